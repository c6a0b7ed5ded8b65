#pragma once

#include <functional>
#include <span>
#include <vector>

#include "app/evaluator_pool.h"
#include "film/picture.h"
#include "film/tile_marks.h"
#include "scene/scene.h"
#include "tracer/integrator.h"

namespace restframe {

// What all pictures of an animation share.
struct RenderContext {
  const Scene& scene;
  const Integrator& integrator;
  EvaluatorPool& evaluators;
  std::function<void(std::size_t)> samples_done;  // called now and then, from any thread
};

// The camera's own time of a picture.
double picture_time(const AnimationSettings& animation, int number);

// Over all exposures.
std::size_t samples_a_pixel(const Scene& scene);

// Whether it is found out how sure the pixels of the beauty are: to stop early, or as a layer.
bool measures_noise(const Scene& scene);

// An empty picture with the scene's window and layers; and one for each of the camera's eyes.
Picture blank_picture(const Scene& scene);
std::vector<Picture> blank_views(const Scene& scene);

// The parts of a picture that are rendered on their own, row by row.
std::vector<PixelWindow> picture_tiles(const PixelWindow& window);

// Writes the pixels of some of picture_tiles(), by their place there, and marks each that is done.
// Otherwise like render_picture().
void render_tiles(const RenderContext& context, int number, std::span<const std::size_t> tiles,
                  Picture& picture, TileMarks& done, Eye eye = Eye::centre);

// Writes every pixel of `picture`. The same bits for any number of threads. Throws Interrupted when a
// signal came, and InputError where a formula gives no finite value.
void render_picture(const RenderContext& context, int number, Picture& picture,
                    Eye eye = Eye::centre);

// The same for all eyes.
void render_views(const RenderContext& context, int number, std::vector<Picture>& views);

}  // namespace restframe

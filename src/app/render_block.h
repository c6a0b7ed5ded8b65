#pragma once

// A packet's worth of pixels, for those who render it.

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "app/render_picture.h"
#include "film/cryptomatte.h"
#include "film/part_totals.h"
#include "tracer/apparent_motion.h"
#include "tracer/apparent_surface.h"
#include "tracer/camera_sampler.h"
#include "tracer/cover_counts.h"
#include "tracer/exposed_camera.h"

namespace restframe {

inline constexpr int block_side = 4;  // a packet is a square of pixels: coherent both ways
static_assert(block_side * block_side == packet_size);

// Where in a block each lane's pixel is, and its place after that of the block's first.
struct BlockPattern {
  PixelLanes offset;
  Lanes<std::uint32_t> place;

  BlockPattern() {
    for (int lane = 0; lane < packet_size; ++lane) {
      offset.x[lane] = lane % block_side;
      offset.y[lane] = lane / block_side;
      place[lane] = morton_place(static_cast<std::uint32_t>(offset.x[lane]),
                                 static_cast<std::uint32_t>(offset.y[lane]));
    }
  }
};

// The lanes of the block whose first pixel is at (left, top), and which of them are pixels of `window`.
void place_block(const BlockPattern& pattern, int left, int top, const PixelWindow& window,
                 PixelLanes& pixels, Lanes<std::int32_t>& active, Lanes<std::uint32_t>& place);

// What the tiles of one picture share.
struct PictureView {
  const RenderContext& context;
  int number;
  PixelWindow window;  // that is kept ...
  // ... of all that could be: packets are the same whichever part is kept, and so are pixels.
  PixelWindow whole;
  CameraSampler sampler;
  ExposedCamera camera;
  BlockPattern pattern;
  MatteIds mattes;
  bool measured;  // how sure pixels are
  bool apparent;  // surfaces as the camera sees them are among the data layers
  std::optional<ApparentMotion> motion;

  PictureView(const RenderContext& of, int picture, const PixelWindow& pixels, Eye eye)
      : context(of),
        number(picture),
        window(pixels),
        whole(whole_window(of.scene.render)),
        sampler(of.scene),
        camera(of.scene, sampler, picture_time(of.scene.animation, picture), eye),
        mattes(matte_ids(of.scene)),
        measured(measures_noise(of.scene)),
        apparent(has_layer(of.scene.output.layers, Layer::depth) ||
                 has_layer(of.scene.output.layers, Layer::apparent_normal)) {
    if (!has_layer(of.scene.output.layers, Layer::motion)) return;
    motion.emplace(of.scene, camera, picture_time(of.scene.animation, picture + 1));
  }
  PictureView(const PictureView&) = delete;  // parts of it refer to others
  PictureView& operator=(const PictureView&) = delete;
};

// A square of pixels that is rendered as one packet after the other.
template <class Tracer>
struct Block {
  const PictureView& view;
  const Tracer& integrator;
  TemporalEvaluator& evaluator;
  int left, top;
  PixelWindow within;  // the part of it that is kept
  PixelLanes pixels;
  Lanes<std::int32_t> active;     // lanes beyond the display and its overscan stay inactive
  PacketId id;                    // of the sample at hand
  CoverCounts* covers = nullptr;  // of all samples; null: not wanted

  Block(const PictureView& of, const Tracer& by, TemporalEvaluator& with, int x, int y)
      : view(of), integrator(by), evaluator(with), left(x), top(y) {
    within = common_part({left, top, block_side, block_side}, view.window);
    id.seed = view.context.scene.render.seed;
    id.picture = static_cast<std::uint32_t>(view.number);
    place_block(view.pattern, left, top, view.whole, pixels, active, id.pixel);
  }
};

template <class Tracer, class Store>
void for_pixels(const Block<Tracer>& block, const Store& store) {
  for (int lane = 0; lane < packet_size; ++lane) {
    const int x = block.pixels.x[lane], y = block.pixels.y[lane];
    if (contains(block.within, {x, y, 1, 1})) store(x, y, lane);
  }
}

template <class Tracer>
void trace(const Block<Tracer>& block, int exposure, const CameraSample& sample,
           RadianceLanes& radiance, const SampleLayers& layers) {
  RayPacket rays;
  rays.active = block.active;
  block.view.camera.rays(exposure, sample, rays);
  block.integrator.trace(rays, block.id, block.evaluator, radiance, layers);
}

// What depends on the camera, of what was hit.
inline void set_as_seen(const PictureView& view, const CameraSample& sample, int lane,
                        SurfaceData& seen) {
  if (view.apparent) {
    const auto object = static_cast<std::size_t>(seen.object);
    set_apparent(view.camera.sight(0, sample, lane),
                 view.context.scene.objects[object].worldline.velocity, seen);
  }
  if (view.motion) seen.motion = (*view.motion)(seen, {sample.film_x[lane], sample.film_y[lane]});
}

template <class Tracer>
void trace_and_store_data(const Block<Tracer>& block, const CameraSample& sample,
                          RadianceLanes& radiance, SampleLayers layers, Picture& picture) {
  SurfaceDataLanes data;
  layers.data = &data;
  trace(block, 0, sample, radiance, layers);
  for_pixels(block, [&](int x, int y, int lane) {
    SurfaceData& seen = data[lane];
    if (seen.hit) set_as_seen(block.view, sample, lane, seen);
    picture.set_data(x, y, seen);
  });
}

// Data layers of samples that are spread over time or the lens: no sample is the ray they hold.
template <class Tracer>
void render_data(const Block<Tracer>& block, Picture& picture) {
  CameraSample sample;
  block.view.sampler.take_center(block.pixels, sample);
  RadianceLanes unused;
  trace_and_store_data(block, sample, unused, {}, picture);
}

// samples: of each exposure.
template <class Tracer>
void store_parts(const Block<Tracer>& block, const PartTotals& parts, int samples,
                 Picture& picture) {
  if (!parts.are_wanted()) return;
  std::array<Vec3f, SampleParts::most_columns> colors;
  const std::span<Vec3f> of_pixel = std::span(colors).first(parts.size());
  for_pixels(block, [&](int x, int y, int lane) {
    parts.take(lane, samples, of_pixel);
    picture.set_parts(x, y, of_pixel);
  });
}

template <class Tracer>
void store(const Block<Tracer>& block, const RadianceLanes& radiance, Picture& picture) {
  const std::span<const Vec4f> lanes(radiance.lane);
  const PixelWindow& within = block.within;
  for (int y = within.top; y < within.bottom(); ++y) {
    const int first = (y - block.top) * block_side + within.left - block.left;
    picture.set_radiance_row(
        within.left, y,
        lanes.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(within.width)));
  }
}

template <class Tracer>
void store_mattes(const Block<Tracer>& block, int samples, const Lanes<float>& scale,
                  Picture& picture) {
  for (const MatteKind kind : picture.mattes()) {
    for_pixels(block, [&](int x, int y, int lane) {
      picture.set_matte(
          x, y, kind,
          matte_ranks(block.covers->of(kind, lane),
                      static_cast<double>(samples) / static_cast<double>(scale[lane])));
    });
  }
}

}  // namespace restframe

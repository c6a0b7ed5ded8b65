#include <fmt/format.h>

#include <algorithm>

#include "app/canvas.h"
#include "app/checkpoint.h"
#include "app/commands.h"
#include "app/job.h"
#include "app/part_files.h"
#include "app/picture_files.h"
#include "app/picture_writer.h"
#include "app/previews.h"
#include "app/progress.h"
#include "app/render_picture.h"
#include "app/resume.h"
#include "app/showing.h"
#include "scene/error.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

struct Work {
  const Job& job;
  const RenderOptions& options;
  Provenance provenance;

  // Of a picture, or of the share of it that is asked for.
  fs::path path(int number) const {
    const fs::path picture = job.path(number);
    return options.tile ? share_path(picture, *options.tile) : picture;
  }
  std::vector<std::size_t> tiles(const Canvas& canvas) const {
    return tiles_of(options.tile.value_or(TileShare{}), canvas.tiles.size());
  }
};

std::size_t pixels_in(const Canvas& canvas, const std::vector<std::size_t>& tiles) {
  std::size_t pixels = 0;
  for (const std::size_t tile : tiles) {
    const PixelWindow& window = canvas.tiles[tile];
    pixels += static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
  }
  return pixels;
}

std::vector<std::size_t> unmarked(std::vector<std::size_t> tiles, const TileMarks& done) {
  const auto is_done = [&](std::size_t tile) { return done.is_marked(tile); };
  tiles.erase(std::remove_if(tiles.begin(), tiles.end(), is_done), tiles.end());
  return tiles;
}

// Renders those tiles of a picture, or of the share of it, that its checkpoint, if there is one, does not hold.
void complete(const Work& work, const RenderContext& context, int number, Canvas& canvas,
              Progress& progress) {
  const fs::path path = checkpoint_path(work.path(number));
  const PartInfo now = part_info(work.provenance, number);
  canvas.clear();
  const auto before = read_part(path, canvas.views());
  if (before && !difference(*before, now).empty()) canvas.clear();  // to be overwritten
  const std::vector<std::size_t> all = work.tiles(canvas);
  std::vector<std::vector<std::size_t>> left;  // of each eye
  for (const TileMarks& done : canvas.done) {
    left.push_back(unmarked(all, done));
    const std::size_t there = pixels_in(canvas, all) - pixels_in(canvas, left.back());
    progress.skip(there * samples_a_pixel(work.job.scene));
  }
  const Checkpoints checkpoints(path, now, canvas.views(),
                                std::chrono::duration<double>(work.options.checkpoint));
  for (std::size_t i = 0; i < left.size(); ++i) {
    render_tiles(context, number, left[i], canvas.pictures[i], canvas.done[i], canvas.eyes[i]);
  }
}

// A checkpoint of its own lets another process's, of the same share, never take its place.
void write_share(const Work& work, int number, Canvas& canvas) {
  write_part(work.path(number), part_info(work.provenance, number), canvas.views(),
             std::atomic<bool>(false));
  std::error_code ignored;
  fs::remove(checkpoint_path(work.path(number)), ignored);
}

void render_pictures(const Work& work, const std::vector<int>& numbers) {
  const Scene& scene = work.job.scene;
  const FrameSet frames(scene, thread_count());
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  // One is rendered while the other is written.
  std::vector<Canvas> canvases;
  for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 2); ++i) {
    canvases.emplace_back(scene);
  }
  const std::size_t pixels =
      canvases[0].eyes.size() * pixels_in(canvases[0], work.tiles(canvases[0]));
  Progress progress(numbers.size(), pixels * samples_a_pixel(scene), work.options.quiet);
  const RenderContext context{scene, integrator, evaluators,
                              [&](std::size_t samples) { progress.samples_done(samples); }};
  const PictureInfo common = common_info(scene);
  PictureWriter writer(scene.output);
  std::size_t current = 0;
  for (const int number : numbers) {
    Canvas& canvas = canvases[current];
    complete(work, context, number, canvas, progress);
    if (work.options.tile) {
      write_share(work, number, canvas);
    } else {
      writer.write(work.job.files(number), canvas.pictures, picture_info(common, scene, number));
    }
    progress.picture_done();
    current = (current + 1) % canvases.size();
  }
  writer.finish();
  writer.report();
}

void print_shares(const Work& work, std::size_t made) {
  const std::vector<int>& numbers = work.job.numbers;
  fmt::print(
      "tile {}/{} of {} of {} pictures made{}: {}{}\n", work.options.tile->part,
      work.options.tile->count, made, numbers.size(),
      made < numbers.size() ? fmt::format(", {} were there already", numbers.size() - made) : "",
      work.path(numbers.front()).string(),
      numbers.size() == 1 ? "" : " to " + work.path(numbers.back()).string());
}

}  // namespace

int render(const RenderOptions& options, const ImportLimits& limits) {
  if (options.tile && wants_show(options)) {
    throw InputError(
        "--tile: --video and --contact-sheet need whole pictures; `restframe merge` "
        "takes them");
  }
  set_thread_count(options.threads);
  const Job job = loaded_job(options, limits);
  const Work work{job, options, provenance_of(job.scene)};
  const ToMake to_make = what_to_make(job, options.overwrite);
  std::vector<int> numbers = to_make.pictures;
  remove_leftovers(job, numbers);
  if (!options.overwrite) numbers = pictures_with_tiles_to_make(job, numbers, options.tile);
  const Show show = planned_show(options, job);
  prepare_folders(job, numbers);
  if (!options.tile) develop_previews(job, to_make.previews);
  if (!numbers.empty()) render_pictures(work, numbers);
  if (!options.quiet && options.tile) print_shares(work, numbers.size());
  if (!options.quiet && !options.tile) print_result(job, numbers.size());
  make_show(show, job.scene);
  return 0;
}

}  // namespace restframe

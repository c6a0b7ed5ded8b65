#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/messages.h"
#include "app/picture_files.h"
#include "app/picture_writer.h"
#include "app/progress.h"
#include "app/render_picture.h"
#include "app/showing.h"
#include "app/signals.h"
#include "scene/error.h"
#include "scene/framing.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

void apply(const RenderOptions& options, Scene& scene) {
  if (options.output) scene.output.path = *options.output;
  if (options.width) scene.render.width = *options.width;
  if (options.height) scene.render.height = *options.height;
  if (options.samples) scene.render.samples = *options.samples;
  if (options.noise) scene.render.noise = *options.noise;
  if (options.exposure) scene.output.exposure = *options.exposure;
  if (options.view) scene.output.view = *options.view;
  if (wants_show(options)) scene.output.preview = true;  // it is made of the previews
}

PictureRange range_of(const RenderOptions& options, const AnimationSettings& animation) {
  const PictureRange all{0, animation.pictures - 1};
  if (!options.pictures) return all;
  if (options.pictures->last > all.last) {
    throw InputError(fmt::format("--pictures: there is no picture {}; the last one is {}",
                                 options.pictures->last, all.last));
  }
  return *options.pictures;
}

}  // namespace

Job loaded_job(const RenderOptions& options, const ImportLimits& limits) {
  Scene scene = loaded_scene(options.scene, limits, options.variant);
  apply(options, scene);
  const PictureRange range = range_of(options, scene.animation);
  Job job{std::move(scene), range};
  // A single picture needs no number in its name.
  if (job.single()) job.scene.animation.pictures = 1;
  throw_faults(job.scene, options.scene);
  if (!job.scene.camera_given) {
    job.scene.camera = framing_camera(job.scene, job.scene.animation.start);
  }
  return job;
}

namespace {

std::size_t samples_a_picture(const Scene& scene) {
  const PixelWindow window = picture_window(scene.render);
  return static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height) *
         samples_a_pixel(scene) * eyes_of(scene.camera).size();
}

bool show_nothing(const std::vector<Picture>& views) {
  return std::all_of(views.begin(), views.end(),
                     [](const Picture& view) { return view.shows_nothing(); });
}

void report_clamped(const WriteReport& written) {
  if (written.clamped > 0) {
    report_warning(
        fmt::format("{} values of the beauty were not finite or beyond what the file "
                    "holds, and were clamped",
                    written.clamped));
  }
  if (written.clamped_data > 0) {
    report_warning(
        fmt::format("{} values of other layers were beyond what half holds, and were clamped; "
                    "output.half names these layers",
                    written.clamped_data));
  }
}

void render_pictures(const Scene& scene, const std::vector<int>& numbers, bool single, bool quiet,
                     int threads) {
  const FrameSet frames(scene, threads);
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  Progress progress(numbers.size(), samples_a_picture(scene), quiet);
  const RenderContext context{scene, integrator, evaluators,
                              [&](std::size_t samples) { progress.samples_done(samples); }};
  // One is rendered while the other is written.
  std::vector<std::vector<Picture>> pictures(std::min<std::size_t>(numbers.size(), 2),
                                             blank_views(scene));
  const PictureInfo common = common_info(scene);
  PictureWriter writer(scene.output);
  std::size_t empty = 0;
  std::size_t current = 0;
  for (const int number : numbers) {
    render_views(context, number, pictures[current]);
    writer.write(picture_files(scene, number, single), pictures[current],
                 picture_info(common, scene, number));
    progress.picture_done();
    if (show_nothing(pictures[current])) ++empty;
    current = (current + 1) % pictures.size();
  }
  writer.finish();
  if (empty > 0) {
    report_warning(
        fmt::format("{} of {} pictures show nothing: the camera meets no object there, as it "
                    "sees them",
                    empty, numbers.size()));
  }
  report_clamped(writer.report());
}

void print_result(const Job& job, std::size_t made) {
  const auto count = static_cast<std::size_t>(job.range.last - job.range.first + 1);
  const auto path = [&](int number) {
    return picture_files(job.scene, number, job.single()).images.front().path.string();
  };
  const std::size_t files = picture_files(job.scene, job.range.first, job.single()).images.size();
  fmt::print("{} of {} pictures made{}: {}{}{}{}\n", made, count,
             made < count ? fmt::format(", {} were there already", count - made) : "",
             path(job.range.first), job.single() ? "" : " to " + path(job.range.last),
             files > 1 ? fmt::format(", and so for {} more layers", files - 1) : "",
             job.scene.output.preview ? ", a .png beside each" : "");
}

}  // namespace

int render(const RenderOptions& options, const ImportLimits& limits) {
  set_thread_count(options.threads);
  const Job job = loaded_job(options, limits);
  const auto& [scene, range] = job;
  const std::vector<int> numbers =
      pictures_to_make(scene, range.first, range.last, options.overwrite);
  const Show show = planned_show(options, scene, range, numbers);
  if (!numbers.empty()) {
    render_pictures(scene, numbers, job.single(), options.quiet, thread_count());
  }
  if (!options.quiet) print_result(job, numbers.size());
  make_show(show, scene);
  return 0;
}

}  // namespace restframe

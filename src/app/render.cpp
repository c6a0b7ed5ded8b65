#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/job.h"
#include "app/messages.h"
#include "app/picture_files.h"
#include "app/picture_writer.h"
#include "app/progress.h"
#include "app/render_picture.h"
#include "app/resume.h"
#include "app/showing.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

void render_pictures(const Job& job, const std::vector<int>& numbers, bool quiet) {
  const Scene& scene = job.scene;
  const FrameSet frames(scene, thread_count());
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  Progress progress(numbers.size(),
                    static_cast<std::size_t>(scene.render.width) *
                        static_cast<std::size_t>(scene.render.height) * samples_a_pixel(scene),
                    quiet);
  const RenderContext context{scene, integrator, evaluators,
                              [&](std::size_t samples) { progress.samples_done(samples); }};
  // One is rendered while the other is written.
  std::vector<Picture> pictures(std::min<std::size_t>(numbers.size(), 2), blank_picture(scene));
  const PictureInfo common = common_info(scene);
  PictureWriter writer(scene.output);
  std::size_t empty = 0;
  std::size_t current = 0;
  for (const int number : numbers) {
    render_picture(context, number, pictures[current]);
    writer.write(job.path(number), pictures[current], picture_info(common, scene, number));
    progress.picture_done();
    if (pictures[current].shows_nothing()) ++empty;
    current = (current + 1) % pictures.size();
  }
  writer.finish();
  if (empty > 0) {
    report_warning(
        fmt::format("{} of {} pictures show nothing: the camera meets no object there, as it "
                    "sees them",
                    empty, numbers.size()));
  }
  if (writer.clamped_values() > 0) {
    report_warning(
        fmt::format("{} values of the beauty were not finite or beyond what the file "
                    "holds, and were clamped",
                    writer.clamped_values()));
  }
}

void print_result(const Job& job, std::size_t made) {
  const std::size_t count = job.numbers.size();
  const std::string first = job.path(job.numbers.front()).string();
  fmt::print("{} of {} pictures made{}: {}{}{}\n", made, count,
             made < count ? fmt::format(", {} were there already", count - made) : "", first,
             count == 1 ? "" : " to " + job.path(job.numbers.back()).string(),
             job.scene.output.preview ? ", a .png beside each" : "");
}

}  // namespace

int render(const RenderOptions& options, const ImportLimits& limits) {
  set_thread_count(options.threads);
  const Job job = loaded_job(options, limits);
  const std::vector<int> numbers = pictures_to_make(job, options.overwrite);
  const Show show = planned_show(options, job);
  prepare_folders(job, numbers);
  if (!numbers.empty()) render_pictures(job, numbers, options.quiet);
  if (!options.quiet) print_result(job, numbers.size());
  make_show(show, job.scene);
  return 0;
}

}  // namespace restframe

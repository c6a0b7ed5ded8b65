#include "app/job.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/picture_files.h"
#include "app/showing.h"
#include "scene/error.h"
#include "scene/framing.h"

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

std::vector<int> numbers_of(const RenderOptions& options, const AnimationSettings& animation) {
  const int last = animation.pictures - 1;
  std::vector<PictureRange> ranges = options.pictures;
  if (ranges.empty()) ranges.push_back({0, last, 1});
  std::vector<int> numbers;
  for (const auto& range : ranges) {
    if (range.last > last) {
      throw InputError(
          fmt::format("--pictures: there is no picture {}; the last one is {}", range.last, last));
    }
    for (int number = range.first; number <= range.last; number += range.step) {
      numbers.push_back(number);
      if (range.step > range.last - number) break;  // the sum might be beyond what an int holds
    }
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

PictureFiles Job::files(int number) const {
  return picture_files(scene, number, numbers.size() == 1);
}

Job loaded_job(const RenderOptions& options, const ImportLimits& limits) {
  Job job{loaded_scene(options.scene, limits, options.variant), {}};
  Scene& scene = job.scene;
  apply(options, scene);
  job.numbers = numbers_of(options, scene.animation);
  // A single picture needs no number in its name. How many there are is no part of a picture.
  if (job.numbers.size() == 1) scene.animation.pictures = 1;
  throw_faults(scene, options.scene);
  if (!scene.camera_given) scene.camera = framing_camera(scene, scene.animation.start);
  return job;
}

void print_result(const Job& job, std::size_t made) {
  const std::size_t count = job.numbers.size();
  const auto image = [&](int number) { return job.files(number).images.front().path.string(); };
  const std::size_t files = job.files(job.numbers.front()).images.size();
  fmt::print("{} of {} pictures made{}: {}{}{}{}\n", made, count,
             made < count ? fmt::format(", {} were there already", count - made) : "",
             image(job.numbers.front()), count == 1 ? "" : " to " + image(job.numbers.back()),
             files > 1 ? fmt::format(", and so for {} more layers", files - 1) : "",
             job.scene.output.preview ? ", a .png beside each" : "");
}

}  // namespace restframe

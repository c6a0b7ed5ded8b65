// An example of the library: a scene file's first object comes nearer at several velocities, a picture
// of each is rendered and written, and the light in its middle is compared with Doppler's formula.
//     consumer scene.toml FOLDER

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/picture_files.h"
#include "app/render_picture.h"
#include "frames/frame_set.h"
#include "importers/importers.h"
#include "scene/error.h"
#include "scene/parallel.h"

using namespace restframe;

namespace {

Picture first_picture(const Scene& scene) {
  const FrameSet frames(scene, thread_count());
  const Integrator integrator = make_integrator(scene, frames);
  EvaluatorPool evaluators(scene.functions);
  Picture picture = blank_picture(scene);
  render_picture({scene, integrator, evaluators, {}}, 0, picture);
  return picture;
}

double doppler_in_the_middle(const Picture& picture) {
  for (const Plane& plane : picture.planes()) {
    if (plane.name == "doppler.D") {
      return static_cast<double>(plane.values[plane.values.size() / 2]);
    }
  }
  throw InputError("the scene asks for no layer \"doppler\"");
}

bool render_at(Scene& scene, double beta, const std::filesystem::path& file) {
  scene.objects.front().worldline.velocity = Velocity::from_beta({0, 0, beta});
  const Picture picture = first_picture(scene);
  write_exr(file, picture, picture_info(common_info(scene), scene, 0));
  const double doppler = doppler_in_the_middle(picture);
  const double expected = std::sqrt((1 + beta) / (1 - beta));
  std::printf("%.1f c: frequencies are seen %.6f times as high, by the formula %.6f\n", beta,
              doppler, expected);
  return std::abs(doppler - expected) < 1e-5;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw InputError("consumer scene.toml FOLDER");
  Warnings warnings;
  Scene scene = load_scene(argv[1], {}, warnings);
  const std::filesystem::path folder = argv[2];
  const bool rest = render_at(scene, 0, folder / "rest.exr");
  const bool fast = render_at(scene, 0.6, folder / "fast.exr");
  return rest && fast ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
}

#include "app/job_needs.h"

#include <algorithm>

#include "app/info_words.h"
#include "film/picture.h"
#include "scene/light_groups.h"

namespace restframe {
namespace {

constexpr std::size_t megabyte = 1'000'000;

// Of all its layers, measured on a picture of one pixel.
std::size_t bytes_a_pixel(const Scene& scene) {
  const Picture picture({0, 0, 1, 1}, scene.output.layers, {}, light_groups(scene));
  std::size_t bytes = sizeof(Vec4f) * picture.rgba().size();
  for (const Plane& plane : picture.planes()) {
    bytes += sizeof(float) * plane.values.size() + sizeof(double) * plane.times.size();
  }
  return bytes;
}

std::size_t bytes_of_pictures(const Scene& scene) {
  // One is rendered while another is written: as the numbers that the file holds, as the growing
  // file in memory, and as the preview.
  constexpr std::size_t copies = 2 + 3;
  const PixelWindow window = picture_window(scene.render);
  return copies * bytes_a_pixel(scene) * eyes_of(scene.camera).size() *
         static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
}

}  // namespace

JobNeeds needs_of(const Scene& scene, const FrameSet& frames) {
  const std::size_t held = bytes_in_memory(scene.meshes) + bytes_in_memory(scene.images) +
                           bytes_in_memory(scene.sky_maps);
  // While an asset is read, its file and what it unpacks to are held beside what is made of them.
  const std::size_t most = 2 * held + frames.peak_embree_bytes() + bytes_of_pictures(scene);
  JobNeeds needs;
  needs.bytes = 256 * megabyte + most + most / 4;
  constexpr std::size_t tile = 32, bytes_a_core = 2000 * megabyte;
  const auto tiles = [](int length) {
    return (static_cast<std::size_t>(length) + tile - 1) / tile;
  };
  const std::size_t cores = std::clamp<std::size_t>(needs.bytes / bytes_a_core, 4, 32);
  needs.cores =
      static_cast<int>(std::min(cores, tiles(scene.render.width) * tiles(scene.render.height)));
  return needs;
}

}  // namespace restframe

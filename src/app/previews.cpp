#include "app/previews.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/signals.h"
#include "film/byte_sum.h"
#include "scene/error.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

const std::filesystem::path& beauty_file(const PictureFiles& files) {
  const auto has_beauty = [](const LayerFile& image) {
    return image.layer.empty() || image.layer == "beauty";
  };
  return std::find_if(files.images.begin(), files.images.end(), has_beauty)->path;
}

}  // namespace

bool has_previews(const Scene& scene) {
  return scene.output.preview && has_layer(scene.output.layers, Layer::beauty);
}

std::string preview_label(const Provenance& provenance, int number,
                          const OutputSettings& settings) {
  const std::string text =
      fmt::format("{}\npicture {}, view {}, exposure {}", pixel_text(provenance), number,
                  static_cast<int>(settings.view), settings.exposure);
  ByteSum sum;
  sum.add(text.data(), text.size());
  return sum.hex();
}

void develop_previews(const Job& job, const std::vector<int>& numbers) {
  const OutputSettings& settings = job.scene.output;
  const Provenance provenance = provenance_of(job.scene);
  parallel_for(numbers.size(), [&](std::size_t i) {
    if (interrupt_requested()) throw Interrupted();
    const PictureFiles files = job.files(numbers[i]);
    write_preview(files.preview, beauty_file(files),
                  {development(settings), false, preview_label(provenance, numbers[i], settings)});
  });
}

}  // namespace restframe

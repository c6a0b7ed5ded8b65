#include "importers/gltf_images.h"

#include <algorithm>

#include "importers/gltf_files.h"
#include "scene/error.h"

namespace restframe {
namespace {

Bytes bytes_of_view(const tinygltf::Model& model, int index) {
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const auto begin = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
  return Bytes(begin, begin + static_cast<std::ptrdiff_t>(view.byteLength));
}

// Takes the bytes of its pixels off `bytes_left`.
Image read_image(const GltfContext& context, const tinygltf::Model& model,
                 const ImageSource& source, int index, std::size_t& bytes_left) {
  const std::string pointer = "/images/" + std::to_string(index);
  const Bytes bytes = source.view >= 0
                          ? bytes_of_view(model, source.view)
                          : read_uri(context, pointer + "/uri", source.uri, bytes_left);
  ImportLimits limits = context.limits;
  limits.image_pixels = std::min(limits.image_pixels, bytes_left / 4);
  Image image = decode_image(bytes, context.file + ":" + pointer, limits);
  bytes_left -= image.rgba.size();
  image.name = source.name.empty() ? "image_" + std::to_string(index) : source.name;
  return image;
}

}  // namespace

std::vector<ImageSource> take_image_sources(Json& document) {
  std::vector<ImageSource> sources;
  if (!document.contains("images")) return sources;
  for (Json& image : document["images"]) {
    ImageSource source;
    source.name = image.value("name", "");
    source.view = image.value("bufferView", -1);
    if (image.contains("uri")) source.uri = std::move(image["uri"].get_ref<std::string&>());
    sources.push_back(std::move(source));
  }
  document.erase("images");
  return sources;
}

std::vector<Image> read_images(const GltfContext& context, const tinygltf::Model& model,
                               const std::vector<ImageSource>& sources,
                               const std::vector<UsedImage>& used) {
  std::vector<Image> images;
  std::size_t bytes_left = context.limits.total_bytes;
  if (used.size() < sources.size()) {
    context.warn("/images", std::to_string(sources.size() - used.size()) + " images are not used");
  }
  for (const UsedImage& each : used) {
    const ImageSource& source = sources[static_cast<std::size_t>(each.image)];
    try {
      images.push_back(read_image(context, model, source, each.image, bytes_left));
    } catch (const InputError& error) {
      if (each.is_seen) throw;
      context.warnings.push_back(error.what() + std::string("; left out"));
      images.push_back({source.name, 1, 1, Bytes(4, 255)});
    }
  }
  return images;
}

}  // namespace restframe

#include "importers/gltf_images.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "importers/gltf_files.h"
#include "importers/image_format.h"
#include "scene/error.h"
#include "scene/material_properties.h"
#include "scene/message.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

// An image on its way from the file to pixels.
struct Decoding {
  std::size_t slot = 0;  // index into the asset's images
  UsedImage used;
  std::string place;  // for faults
  Bytes file;         // bytes that the buffers do not hold
  ByteSpan bytes;
  std::size_t pixels = 0;
  std::optional<std::string> fault;
};

ByteSpan bytes_of_view(const tinygltf::Model& model, int index) {
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  return ByteSpan(data).subspan(view.byteOffset, view.byteLength);
}

std::string image_pointer(int image) {
  return "/images/" + std::to_string(image);
}

// Of images, how many bytes more may be read and decoded.
struct Budget {
  std::size_t file_bytes, pixel_bytes;
};

void warn_of_type(const GltfContext& context, const std::string& pointer, const ImageSource& source,
                  ByteSpan bytes) {
  const char* kind = image_kind(bytes);
  if (kind == nullptr || source.mime_type.empty()) return;
  const std::string_view name = kind;
  const std::string type = name == "PNG" ? "image/png" : name == "JPEG" ? "image/jpeg" : "";
  if (type.empty() || type == source.mime_type) return;
  context.warn(pointer + "/mimeType", "is " + quote(source.mime_type) + ", but the image is " +
                                          kind + " and read as that");
}

void open(const GltfContext& context, const tinygltf::Model& model,
          const std::vector<ImageSource>& sources, Decoding& image, Budget& left) {
  const ImageSource& source = sources[static_cast<std::size_t>(image.used.image)];
  const std::string pointer = image_pointer(image.used.image);
  image.place = context.place(pointer);
  if (source.view >= 0) {
    image.bytes = bytes_of_view(model, source.view);
  } else {
    image.file = read_uri(context, pointer + "/uri", source.uri, left.file_bytes);
    image.bytes = image.file;
    left.file_bytes -= image.file.size();
  }
  warn_of_type(context, pointer, source, image.bytes);
  for (const int same : source.same) {
    warn_of_type(context, image_pointer(same), sources[static_cast<std::size_t>(same)],
                 image.bytes);
  }
  image.pixels = count_image_pixels(image.bytes, image.place, context.limits);
  if (4 * image.pixels > left.pixel_bytes) {
    context.fault(pointer, "the images up to this one are larger than " +
                               std::to_string(context.limits.total_bytes) +
                               " bytes, the limit; --max-bytes raises it");
  }
  left.pixel_bytes -= 4 * image.pixels;
}

// Whatever is wrong with the image that its beginning tells; without decoding.
std::vector<Decoding> open_all(const GltfContext& context, const tinygltf::Model& model,
                               const std::vector<ImageSource>& sources,
                               const std::vector<UsedImage>& used) {
  std::vector<Decoding> images;
  for (std::size_t i = 0; i < used.size(); ++i) {
    images.emplace_back().slot = i;
    images.back().used = used[i];
  }
  std::sort(images.begin(), images.end(),
            [](const Decoding& a, const Decoding& b) { return a.used.image < b.used.image; });
  Budget left{context.limits.total_bytes, context.limits.total_bytes};
  for (Decoding& image : images) {
    try {
      open(context, model, sources, image, left);
    } catch (const InputError& error) {
      image.fault = error.what();
      if (image.used.is_seen) break;  // nothing further counts
    }
  }
  return images;
}

// Frees the buffers, which only images still need, where copies of the images' bytes take less than
// half as much.
void release_buffers(tinygltf::Model& model, std::vector<Decoding>& images) {
  std::size_t held = 0, copied = 0;
  for (const tinygltf::Buffer& buffer : model.buffers) held += buffer.data.size();
  for (const Decoding& image : images) copied += image.bytes.size() - image.file.size();
  if (copied > held / 2) return;
  for (Decoding& image : images) {
    if (!image.file.empty()) continue;
    image.file.assign(image.bytes.begin(), image.bytes.end());
    image.bytes = image.file;
  }
  for (tinygltf::Buffer& buffer : model.buffers) Bytes().swap(buffer.data);
}

void decode(const GltfContext& context, Decoding& image, Image& target) {
  if (image.fault || image.bytes.empty()) return;
  try {
    std::string name = std::move(target.name);
    target = decode_image(image.bytes, image.place, context.limits);
    target.name = std::move(name);
  } catch (const InputError& error) {
    image.fault = error.what();
  }
  image.file = Bytes();
}

// In runs that together have no more pixels than one image may have, since decoding takes several
// times what remains.
void decode_all(const GltfContext& context, std::vector<Decoding>& images, Asset& asset) {
  for (std::size_t first = 0; first < images.size();) {
    std::size_t count = 1, pixels = images[first].pixels;
    while (first + count < images.size() &&
           pixels + images[first + count].pixels <= context.limits.image_pixels) {
      pixels += images[first + count++].pixels;
    }
    parallel_for(count, [&](std::size_t i) {
      Decoding& image = images[first + i];
      decode(context, image, asset.images[image.slot]);
    });
    first += count;
  }
}

// A view, or no view and a URI: the bytes are the same where these are.
void find_same(std::vector<ImageSource>& sources) {
  std::map<std::pair<int, std::string_view>, int> firsts;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto index = static_cast<int>(i);
    const auto [first, is_new] = firsts.try_emplace({sources[i].view, sources[i].uri}, index);
    sources[i].same_as = first->second;
    if (!is_new) sources[static_cast<std::size_t>(first->second)].same.push_back(index);
  }
}

void warn_of_unused(const GltfContext& context, const std::vector<ImageSource>& sources,
                    const std::vector<UsedImage>& used) {
  std::size_t unused = sources.size();
  for (const UsedImage& each : used) {
    unused -= 1 + sources[static_cast<std::size_t>(each.image)].same.size();
  }
  if (unused == 0) return;
  context.warn("/images", std::to_string(unused) + " images are not used");
}

// Materials go without it; one white pixel keeps its place.
void leave_out(std::size_t image, Asset& asset) {
  asset.images[image].width = asset.images[image].height = 1;
  asset.images[image].rgba.assign(4, 255);
  for (Material& material : asset.materials) {
    for (const TextureProperty& property : texture_properties) {
      TextureUse& use = material.*property.member;
      if (use.texture < 0) continue;
      const Texture& texture = asset.textures[static_cast<std::size_t>(use.texture)];
      if (texture.image == static_cast<int>(image)) use = {};
    }
  }
}

}  // namespace

std::vector<ImageSource> take_image_sources(Json& document) {
  std::vector<ImageSource> sources;
  if (!document.contains("images")) return sources;
  for (Json& image : document["images"]) {
    ImageSource source;
    source.name = image.value("name", "");
    source.mime_type = image.value("mimeType", "");
    source.view = image.value("bufferView", -1);
    if (image.contains("uri")) source.uri = std::move(image["uri"].get_ref<std::string&>());
    sources.push_back(std::move(source));
  }
  document.erase("images");
  find_same(sources);
  return sources;
}

void share_images(const std::vector<ImageSource>& sources, tinygltf::Model& model) {
  for (tinygltf::Texture& texture : model.textures) {
    if (texture.source < 0) continue;
    texture.source = sources[static_cast<std::size_t>(texture.source)].same_as;
  }
}

void read_images(const GltfContext& context, tinygltf::Model& model,
                 const std::vector<ImageSource>& sources, const std::vector<UsedImage>& used,
                 Asset& asset) {
  warn_of_unused(context, sources, used);
  for (const UsedImage& each : used) {
    const std::string& name = sources[static_cast<std::size_t>(each.image)].name;
    asset.images.emplace_back().name = name.empty() ? "image_" + std::to_string(each.image) : name;
  }
  std::vector<Decoding> images = open_all(context, model, sources, used);
  release_buffers(model, images);
  const auto ends_it = [](const Decoding& image) { return image.fault && image.used.is_seen; };
  if (std::none_of(images.begin(), images.end(), ends_it)) decode_all(context, images, asset);
  for (const Decoding& image : images) {
    if (ends_it(image)) throw InputError(*image.fault);
    if (!image.fault) continue;
    context.warnings.push_back(*image.fault + "; left out");
    leave_out(image.slot, asset);
  }
}

}  // namespace restframe

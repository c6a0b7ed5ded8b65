// Textures, samplers and images, and how materials use them.

#include <algorithm>
#include <initializer_list>

#include "importers/gltf_check.h"

namespace restframe {
namespace {

// What goes into single precision.
constexpr double largest = 1e30;
constexpr std::uint64_t most_uv_sets = 1000;

void check_one_of(const Place& place, const char* key,
                  std::initializer_list<std::uint64_t> allowed) {
  if (!place.has(key)) return;
  const Place member = place.member(key);
  const std::uint64_t value = member.as_integer(0, 0xFFFF);
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
    member.fault("is " + std::to_string(value) + ", not one of glTF's");
  }
}

void check_image(const Place& image, const Place& document) {
  if (image.has("uri") == image.has("bufferView")) {
    image.fault("must have either a uri or a bufferView");
  }
  image.check_string("uri");
  image.check_string("mimeType");
  image.index("bufferView", count_of(document, "bufferViews"));
}

void check_sampler(const Place& sampler) {
  constexpr std::uint64_t nearest = 9728, linear = 9729, clamp = 33071, mirrored = 33648,
                          repeat = 10497;
  check_one_of(sampler, "magFilter", {nearest, linear});
  check_one_of(sampler, "minFilter", {nearest, linear, 9984, 9985, 9986, 9987});
  check_one_of(sampler, "wrapS", {clamp, mirrored, repeat});
  check_one_of(sampler, "wrapT", {clamp, mirrored, repeat});
}

// Images of other kinds than PNG and JPEG are not read, but what is said of them must be sound.
void check_texture(const Place& texture, const Place& document) {
  const std::size_t images = count_of(document, "images");
  texture.index("source", images);
  texture.index("sampler", count_of(document, "samplers"));
  if (!texture.has("extensions")) return;
  const Place extensions = texture.member("extensions");
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp", "MSFT_texture_dds"}) {
    if (!extensions.has(name)) continue;
    const Place extension = extensions.member(name);
    extension.require_object();
    extension.index("source", images);
  }
}

void check_transform(const Place& use) {
  if (!use.has("extensions")) return;
  const Place extensions = use.member("extensions");
  extensions.require_object();
  if (!extensions.has("KHR_texture_transform")) return;
  const Place transform = extensions.member("KHR_texture_transform");
  transform.require_object();
  transform.check_numbers("offset", 2, -largest, largest);
  transform.check_numbers("scale", 2, -largest, largest);
  transform.check_number("rotation", -largest, largest);
  transform.integer("texCoord", 0, most_uv_sets, 0);
}

}  // namespace

void check_texture_use(const Place& place, const char* key, const Place& document) {
  if (!place.has(key)) return;
  const Place use = place.member(key);
  use.require_object();
  use.require_member("index");
  use.index("index", count_of(document, "textures"));
  use.integer("texCoord", 0, most_uv_sets, 0);
  use.check_number("scale", -largest, largest);  // of a normal texture
  check_transform(use);
}

void check_textures(const Place& document) {
  for_each_object(document, "images", [&](const Place& image) { check_image(image, document); });
  for_each_object(document, "samplers", check_sampler);
  for_each_object(document, "textures",
                  [&](const Place& texture) { check_texture(texture, document); });
}

}  // namespace restframe

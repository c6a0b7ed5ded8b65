#include "importers/obj_texture.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "importers/asset_file.h"
#include "importers/input_file.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Options that would change what the picture shows where, and which are not followed.
bool has_unused_options(const tinyobj::texture_option_t& options) {
  const auto differs = [](const tinyobj::real_t(&v)[3], tinyobj::real_t expected) {
    return v[0] != expected || v[1] != expected || v[2] != expected;
  };
  return differs(options.origin_offset, 0) || differs(options.scale, 1) ||
         differs(options.turbulence, 0) || options.brightness != 0 || options.contrast != 1;
}

}  // namespace

void ObjTextures::apply(const MtlMaterial& source, Material& material) {
  const tinyobj::material_t& values = source.values;
  if (source.given.count("map_Kd")) {
    material.base_color_texture =
        use(source, "map_Kd", values.diffuse_texname, values.diffuse_texopt);
  }
  if (source.given.count("map_Ke")) {
    material.emission_texture =
        use(source, "map_Ke", values.emissive_texname, values.emissive_texopt);
    if (!source.given.count("Ke") && material.emission_texture.texture >= 0) {
      material.emission.value = Vec3f(1);
    }
  }
}

TextureUse ObjTextures::use(const MtlMaterial& source, const char* key, const std::string& name,
                            const tinyobj::texture_option_t& options) {
  if (name.empty()) {
    warn(source, key, "names no file that could be read, not used");
    return {};
  }
  if (has_unused_options(options)) warn(source, key, "options -o, -s, -t and -mm are not used");
  const std::string what = fmt::format("{}: material {}: {}: {}", source.file.string(),
                                       quote(source.name), key, quote(name));
  const std::optional<Path> file = find_asset_file(root_, folder_of(source.file), name, what);
  if (!file) {
    warn(source, key, fmt::format("image {} does not exist, not used", quote(name)));
    return {};
  }
  const auto next = static_cast<int>(asset_.textures.size());
  const auto [entry, is_new] = textures_.try_emplace(std::pair(image(*file), options.clamp), next);
  if (is_new) {
    Texture texture;
    texture.image = entry->first.first;
    if (options.clamp) texture.wrap_u = texture.wrap_v = Wrap::clamp;
    asset_.textures.push_back(texture);
  }
  return {entry->second, 0};
}

int ObjTextures::image(const Path& file) {
  const auto known = images_.find(file);
  if (known != images_.end()) return known->second;
  const std::string name = file.string();
  const auto bytes = read_input_file<std::vector<std::uint8_t>>(file, limits_.total_bytes, name);
  asset_.images.push_back(decode_image(bytes, name, limits_));
  asset_.files.insert(file);
  bytes_ += asset_.images.back().rgba.size();
  if (bytes_ > limits_.total_bytes) {
    throw InputError(fmt::format("{}: all images need more than {} bytes, the limit", name,
                                 limits_.total_bytes));
  }
  const auto index = static_cast<int>(asset_.images.size()) - 1;
  images_.emplace(file, index);
  return index;
}

void ObjTextures::warn(const MtlMaterial& source, const char* key, const std::string& what) {
  warnings_.push_back(
      fmt::format("{}: material {}: {}: {}", source.file.string(), quote(source.name), key, what));
}

}  // namespace restframe

#include "importers/ply_texture.h"

#include <fmt/format.h>

#include <optional>

#include "importers/asset_file.h"
#include "importers/input_file.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {

void add_ply_texture(const std::vector<std::string>& names, const Path& path,
                     const ImportLimits& limits, Asset& asset, Warnings& warnings) {
  if (names.empty()) return;
  const std::string what = fmt::format("{}: TextureFile {}", path.string(), quote(names[0]));
  if (asset.meshes.at(0).uvs[0].empty()) {
    warnings.push_back(what + " is not used: there are no texture coordinates");
    return;
  }
  if (names.size() > 1) {
    warnings.push_back(fmt::format("{}: {} TextureFile comments, only the first is used",
                                   path.string(), names.size()));
  }
  const Path folder = folder_of(path);
  const std::optional<Path> file = find_asset_file(folder, folder, names[0], what);
  if (!file) {
    warnings.push_back(what + " does not exist, not used");
    return;
  }
  const std::string name = file->string();
  const auto bytes = read_input_file<std::vector<std::uint8_t>>(*file, limits.total_bytes, name);
  asset.images.push_back(decode_image(bytes, name, limits));
  asset.files.insert(*file);
  Texture texture;
  texture.image = 0;
  asset.textures.push_back(texture);
  asset.materials.at(0).base_color.value = Vec3f(1);
  asset.materials.at(0).base_color_texture.texture = 0;
}

}  // namespace restframe

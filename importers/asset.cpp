#include <fmt/format.h>

#include "importers/importers.h"
#include "scene/error.h"
#include "scene/file_names.h"

namespace restframe {

Asset load_asset(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  const std::string extension = lower_extension(path);
  const bool is_gltf = extension == ".gltf" || extension == ".glb";
  if (!is_gltf && extension != ".obj") {
    throw InputError(
        fmt::format("{}: the extension is \"{}\", must be .gltf, .glb or .obj (or .toml for "
                    "a scene file)",
                    path.string(), extension));
  }
  return is_gltf ? load_gltf(path, limits, warnings) : load_obj(path, limits, warnings);
}

}  // namespace restframe

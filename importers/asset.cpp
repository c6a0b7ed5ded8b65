#include <fmt/format.h>

#include <array>

#include "importers/importers.h"
#include "scene/error.h"
#include "scene/file_names.h"

namespace restframe {
namespace {

struct Format {
  const char* extension;
  Asset (*load)(const Path& path, const ImportLimits& limits, Warnings& warnings);
};

constexpr std::array<Format, 6> formats = {{
    {".gltf", load_gltf},
    {".glb", load_gltf},
    {".obj", load_obj},
    {".ply", load_ply},
    {".stl", load_stl},
    {".off", load_off},
}};

}  // namespace

Asset load_asset(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  const std::string extension = lower_extension(path);
  for (const Format& format : formats) {
    if (extension == format.extension) return format.load(path, limits, warnings);
  }
  throw InputError(
      fmt::format("{}: the extension is \"{}\", must be .gltf, .glb, .obj, .ply, .stl or .off (or "
                  ".toml for a scene file)",
                  path.string(), extension));
}

}  // namespace restframe

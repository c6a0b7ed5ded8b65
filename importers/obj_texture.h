#pragma once

#include <map>
#include <string>
#include <utility>

#include "importers/importers.h"
#include "importers/mtl_read.h"

namespace restframe {

// Adds the textures that MTL materials name to an asset, each image once.
class ObjTextures {
 public:
  // Images must lie in `root` or below.
  ObjTextures(Path root, const ImportLimits& limits, Asset& asset, Warnings& warnings)
      : root_(std::move(root)), limits_(limits), asset_(asset), warnings_(warnings) {}

  // Gives `material` the textures of `source`. A missing image is a warning; throws InputError for
  // one that can not be read.
  void apply(const MtlMaterial& source, Material& material);

 private:
  TextureUse use(const MtlMaterial& source, const char* key, const std::string& name,
                 const tinyobj::texture_option_t& options);
  int image(const Path& file);
  void warn(const MtlMaterial& source, const char* key, const std::string& what);

  Path root_;
  const ImportLimits& limits_;
  Asset& asset_;
  Warnings& warnings_;
  std::size_t bytes_ = 0;  // of decoded images
  std::map<Path, int> images_;
  std::map<std::pair<int, bool>, int> textures_;  // by image and whether it is clamped
};

}  // namespace restframe

#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "importers/importers.h"
#include "importers/mixed_image.h"
#include "importers/mtl_read.h"

namespace restframe {

// Adds the textures that MTL materials name to an asset, each image once.
class ObjTextures {
 public:
  // Images must lie in `root` or below.
  ObjTextures(Path root, const ImportLimits& limits, Asset& asset, Warnings& warnings)
      : root_(std::move(root)), limits_(limits), asset_(asset), warnings_(warnings) {}

  // Gives `material` the textures of `source`. An image that is missing, or neither PNG nor JPEG,
  // is a warning; throws InputError for one that can not be read.
  void apply(const MtlMaterial& source, Material& material);

 private:
  // A texture statement whose file is there.
  struct Found {
    const MtlMap* map;
    std::string file;
  };

  void apply_color(const MtlMaterial& source, Material& material);
  void apply_emission(const MtlMaterial& source, Material& material);
  void apply_metallic_roughness(const MtlMaterial& source, Material& material);
  void apply_normal(const MtlMaterial& source, Material& material);
  void apply_layers(const MtlMaterial& source, Material& material);

  std::optional<Found> find(const MtlMaterial& source, const char* what);
  // One channel of the picture as another channel of the texture.
  void apply_scalar(const MtlMaterial& source, const char* what, std::size_t channel,
                    TextureUse& texture);
  void check_options(const MtlMaterial& source, const MtlMap& used, const MtlMap& other);
  // As colour or as data, with the options of `map`.
  TextureUse use(const ChannelSources& sources, const MtlMap& map, bool srgb);
  int image(const ChannelSources& sources);
  Image decode(const std::string& file);
  bool is_picture(const std::string& file);
  void warn(const MtlMaterial& source, const std::string& key, const std::string& what);

  Path root_;
  const ImportLimits& limits_;
  Asset& asset_;
  Warnings& warnings_;
  std::size_t bytes_ = 0;  // of decoded images
  std::map<ChannelSources, int> images_;
  std::map<std::tuple<int, bool, bool, bool>, int> textures_;  // by image, srgb, clamped, smooth
};

}  // namespace restframe

#pragma once

// What `restframe info` says of an asset.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/node_folding.h"
#include "importers/importers.h"

namespace restframe {

struct AssetReport {
  std::string file;               // as the user or the scene file names it
  std::uintmax_t file_bytes = 0;  // with all that it was read from
  Asset asset;
  FoldedNode nodes;                 // of the default scene
  std::vector<char> closed;         // of each mesh
  std::vector<std::size_t> placed;  // likewise: how often the default scene has it
  std::size_t node_count = 0, triangle_count = 0, placed_count = 0;  // in the default scene
  Bounds bounds;                                                     // of the default scene
};

AssetReport report_on(const std::string& file, const Path& path, const ImportLimits& limits,
                      Warnings& warnings);

// A tree, and a list for each kind of thing; long lists are cut.
std::string text_of(const AssetReport& report);

nlohmann::ordered_json json_of(const AssetReport& report);

}  // namespace restframe

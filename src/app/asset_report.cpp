#include "app/asset_report.h"

#include <system_error>

#include "app/info_words.h"

namespace restframe {
namespace {

std::uintmax_t size_of_files(const Path& path, const Asset& asset) {
  const auto size_of = [](const Path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    return error ? 0 : size;
  };
  std::uintmax_t sum = size_of(path);
  for (const Path& file : asset.files) sum += size_of(file);
  return sum;
}

std::vector<PlacedMesh> parts_of(const Asset& asset, const NodeRanges& nodes) {
  std::vector<PlacedMesh> parts;
  auto range = nodes.begin();
  for (const Part& part : asset.parts) {
    while (range != nodes.end() && range->end <= part.node) ++range;
    if (range == nodes.end()) break;
    if (range->begin <= part.node) parts.push_back({part.mesh, part.asset_from_mesh});
  }
  return parts;
}

void count_parts(const std::vector<PlacedMesh>& parts, AssetReport& report) {
  report.placed.assign(report.asset.meshes.size(), 0);
  report.placed_count = parts.size();
  for (const PlacedMesh& part : parts) {
    const auto mesh = static_cast<std::size_t>(part.mesh);
    ++report.placed[mesh];
    report.triangle_count += report.asset.meshes[mesh].triangles.size();
  }
}

}  // namespace

AssetReport report_on(const std::string& file, const Path& path, const ImportLimits& limits,
                      Warnings& warnings) {
  AssetReport report;
  report.file = file;
  report.asset = load_asset(path, limits, warnings);
  const Asset& asset = report.asset;
  report.file_bytes = size_of_files(path, asset);
  const NodeRanges nodes = nodes_of_default_scene(asset.tree);
  for (const NodeRange& range : nodes) {
    report.node_count += static_cast<std::size_t>(range.end - range.begin);
  }
  report.nodes = folded_nodes(asset, nodes);
  const std::vector<PlacedMesh> parts = parts_of(asset, nodes);
  count_parts(parts, report);
  report.bounds = bounds_of_placed(asset.meshes, parts);
  report.closed = closedness_of(asset.meshes);
  return report;
}

}  // namespace restframe

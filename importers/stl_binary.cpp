#include <fmt/format.h>

#include "importers/byte_reader.h"
#include "importers/stl_solid.h"
#include "scene/error.h"

namespace restframe {
namespace {

constexpr std::size_t name_size = 80, head_size = 84, facet_size = 50;

// The number of triangles, which the file has room for.
std::uint32_t read_count(ByteReader& file, const Path& path, const ImportLimits& limits,
                         Warnings& warnings) {
  if (file.size() < head_size) {
    file.fail(fmt::format(
        "the file has {} bytes: neither a binary STL, of at least {} bytes, nor a text that begins "
        "with \"solid\"",
        file.size(), head_size));
  }
  file.skip(name_size);
  const auto count = file.read<std::uint32_t>(std::endian::little);
  const std::uint64_t expected = head_size + std::uint64_t{facet_size} * count;
  if (expected > file.size()) {
    throw InputError(fmt::format(
        "{}: byte {}: {} triangles need {} bytes, the file has {} (truncated, or no STL)",
        path.string(), name_size, count, expected, file.size()));
  }
  if (count == 0) throw InputError(path.string() + ": nothing to render: no triangles");
  if (count > limits.triangles) {
    throw InputError(
        fmt::format("{}: {} triangles, the limit is {}", path.string(), count, limits.triangles));
  }
  if (expected < file.size()) {
    warnings.push_back(fmt::format("{}: byte {}: {} bytes after the last triangle are not used",
                                   path.string(), expected, file.size() - expected));
  }
  return count;
}

Vec3f read_vector(ByteReader& file) {
  Vec3f result;
  for (int i = 0; i < 3; ++i) result[i] = file.read<float>(std::endian::little);
  return result;
}

}  // namespace

Mesh read_stl_binary(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  ByteReader file(path, limits.total_bytes);
  const std::uint32_t count = read_count(file, path, limits, warnings);
  SolidBuilder solid;
  std::uint32_t with_attributes = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    file.skip(sizeof(Vec3f));  // the normal: the corners' order says the same
    std::array<Vec3f, 3> corners;
    for (Vec3f& corner : corners) {
      corner = read_vector(file);
      const std::string fault = corner_fault(corner);
      if (!fault.empty()) file.fail(fmt::format("triangle {}: {}", i, fault));
    }
    if (file.read<std::uint16_t>(std::endian::little) != 0) ++with_attributes;
    solid.add(corners);
  }
  if (with_attributes > 0) {
    warnings.push_back(
        fmt::format("{}: {} triangles have attribute bytes (colours, in some programs), not used",
                    path.string(), with_attributes));
  }
  return solid.take("");
}

}  // namespace restframe

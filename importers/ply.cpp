#include <fmt/format.h>

#include <algorithm>

#include "importers/mesh_asset.h"
#include "importers/mesh_builder.h"
#include "importers/ply_body.h"
#include "importers/ply_texture.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Whether what follows a header is but printable characters, in whose place bytes should be.
bool looks_like_text(ByteReader& file) {
  constexpr std::size_t enough = 64;
  const std::string_view head = file.peek(enough);
  return head.size() > 8 && std::all_of(head.begin(), head.end(), [](char c) {
           return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
         });
}

std::vector<std::string> read_body(ByteReader& file, const PlyHeader& header, const Path& path,
                                   const ImportLimits& limits, MeshBuilder& builder) {
  if (header.format == PlyFormat::text) {
    TextFile text(path, limits.total_bytes);
    PlyText values(text, header.bytes);
    return read_ply_body(values, header, builder);
  }
  if (looks_like_text(file)) file.fail("text follows, where the header says binary");
  const bool little = header.format == PlyFormat::little_endian;
  PlyBytes values(file, little ? std::endian::little : std::endian::big);
  return read_ply_body(values, header, builder);
}

void warn_of_unused(const std::vector<std::string>& names, const Path& path, Warnings& warnings) {
  constexpr std::size_t most = 8;
  if (names.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + quote(names[i]);
  }
  if (names.size() > most) list += fmt::format(" and {} more", names.size() - most);
  warnings.push_back(fmt::format("{}: not used: {}", path.string(), list));
}

}  // namespace

Asset load_ply(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  ByteReader file(path, limits.total_bytes);
  const PlyHeader header = read_ply_header(file, path, warnings);
  check_ply_size(header, file.left(), path);
  MeshBuilder builder(path.string(), limits);
  warn_of_unused(read_body(file, header, path, limits, builder), path, warnings);
  std::vector<Mesh> meshes(1);
  meshes[0] = builder.take(warnings);
  Asset asset = make_mesh_asset(path, std::move(meshes), warnings);
  add_ply_texture(header.textures, path, limits, asset, warnings);
  return asset;
}

}  // namespace restframe

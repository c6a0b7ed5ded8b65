#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "importers/byte_reader.h"
#include "importers/importers.h"

namespace restframe {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

// In a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  // of a list's length; absent: a single number
};

// A table: rows of the same properties.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };

// What a PLY file's first lines say follows, in this order.
struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::vector<std::string> textures;  // images that `comment TextureFile` lines name
  std::size_t bytes = 0;              // of these lines
};

// Reads up to the line end after end_header. Throws InputError: FILE:LINE:COLUMN.
PlyHeader read_ply_header(ByteReader& file, const Path& path, Warnings& warnings);

// Throws InputError where the rest of a file, of `left` bytes, is too short for what the header
// promises.
void check_ply_size(const PlyHeader& header, std::size_t left, const Path& path);

}  // namespace restframe

#pragma once

// Draco's decoder, with checks where it has none: what a stream claims to hold is compared with
// what is expected before memory is taken for it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace restframe {

struct DracoStream {
  const std::uint8_t* bytes = nullptr;
  std::size_t length = 0;
};

// An attribute that is wanted, as `components` numbers of a glTF component type a vertex, packed.
struct DracoAttribute {
  std::uint32_t id = 0;
  int component_type = 0, components = 0;
  std::size_t offset = 0;  // where its values are to be written
};

struct DracoWanted {
  std::size_t triangles = 0, vertices = 0;
  std::vector<DracoAttribute> attributes;
  std::size_t size = 0;        // of what is written in all
  std::size_t most_bytes = 0;  // that decoding may take
};

// Writes the indices, 32 bits each, three a triangle, and the attributes behind them. Returns what
// is wrong with the stream, or nothing. Indices may be out of range, numbers not finite.
std::string decode_draco_mesh(const DracoStream& stream, const DracoWanted& wanted,
                              std::vector<std::uint8_t>& bytes);

}  // namespace restframe

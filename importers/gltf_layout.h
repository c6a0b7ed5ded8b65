#pragma once

// How glTF lays numbers out: sizes of components and elements.

#include <cstddef>
#include <cstdint>
#include <string>

namespace restframe {

enum ComponentType : std::uint64_t {
  component_i8 = 5120,
  component_u8 = 5121,
  component_i16 = 5122,
  component_u16 = 5123,
  component_u32 = 5125,
  component_f32 = 5126,
};

// In bytes; 0 for a type that glTF does not have.
inline std::size_t component_size(std::uint64_t component_type) {
  switch (component_type) {
    case component_i8:
    case component_u8:
      return 1;
    case component_i16:
    case component_u16:
      return 2;
    case component_u32:
    case component_f32:
      return 4;
    default:
      return 0;
  }
}

// The bytes of one element ("VEC3" of floats: 12); columns of matrices start at multiples of 4.
inline std::size_t element_size(std::uint64_t component_type, const std::string& type) {
  const std::size_t size = component_size(component_type);
  if (type == "SCALAR") return size;
  if (type.size() != 4 || type[3] < '2' || type[3] > '4') return 0;
  const auto n = static_cast<std::size_t>(type[3] - '0');
  if (type.compare(0, 3, "VEC") == 0) return n * size;
  if (type.compare(0, 3, "MAT") == 0) return n * ((n * size + 3) / 4 * 4);
  return 0;
}

// The bytes at the end of an element that need not be there after the last one: a matrix's padding.
inline std::size_t end_padding(std::uint64_t component_type, const std::string& type) {
  if (type.compare(0, 3, "MAT") != 0) return 0;
  const auto n = static_cast<std::size_t>(type[3] - '0');
  return (4 - n * component_size(component_type) % 4) % 4;
}

}  // namespace restframe

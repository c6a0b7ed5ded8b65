#pragma once

#include <cstdint>

#include "importers/importers.h"
#include "importers/text_words.h"

namespace restframe {

// The first lines of an OFF file: [ST][C][N][4]OFF, then the numbers of vertices, faces and edges.
struct OffHeader {
  bool has_uvs = false, has_colors = false, has_normals = false;
  bool has_weight = false;  // a fourth coordinate, by which the others are divided
  std::uint64_t vertices = 0, faces = 0;
};

// Throws InputError where there is none, or where it promises more than a file of `size` bytes can
// hold. Files without the word OFF begin with the numbers.
OffHeader read_off_header(TextWords& words, std::size_t size);

}  // namespace restframe

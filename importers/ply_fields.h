#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "importers/ply_header.h"

namespace restframe {

// What a property of a vertex or face means to us.
enum class PlyField : std::uint8_t {
  x,
  y,
  z,
  normal_x,
  normal_y,
  normal_z,
  u,
  v,
  red,
  green,
  blue,
  alpha,
  corners,  // a list of vertex indices
  corner_uvs,
  none
};

// Its fields, one a property in their order, by all spellings that are known; the second of two
// spellings of one field, and what is incomplete, is none.
struct PlyFields {
  std::vector<PlyField> of_property;
  bool has_position = false, has_normal = false, has_uv = false, has_color = false,
       has_alpha = false, has_corners = false;
};

PlyFields vertex_fields(const PlyElement& element);
PlyFields face_fields(const PlyElement& element);

// The factor that brings a colour of this type into 0..1; 1 for floating point.
double color_scale(PlyType type);

bool is_real(PlyType type);

}  // namespace restframe

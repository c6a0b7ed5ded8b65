#pragma once

// How much of the light a rough surface scatters in all, for a given view: integrals that have no
// closed form, tabulated when they are first asked for (in milliseconds).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "tracer/bsdf.h"
#include "tracer/bsdf_terms.h"

namespace restframe {

// Of microfacets (GGX) that scatter light once.
struct FacetAlbedo {
  float all = 1;      // if each reflected all
  float grazing = 0;  // if each reflected as much as schlick() says
};

// Nodes are even in roughness. What is lost depends on the cosine over alpha, if both are small; what
// is left, on the cosine.
struct FacetAlbedoTable {
  static constexpr int cosines = 33, roughnesses = 17;
  // What a cell between nodes has at its four corners, 16 bits for 0 to 1 each, so that a lane has them with
  // one load: cosine by cosine, then roughness by roughness.
  using Cells = std::array<std::uint64_t, std::size_t{cosines - 1} * (roughnesses - 1)>;
  Cells all;    // even in cosine / (cosine + alpha)
  Cells share;  // grazing over all; even in the cosine's root
};
const FacetAlbedoTable& facet_albedo_table();

// A place between nodes 0 to `count` - 1 for x from 0 to 1: the one before, and how far from it.
struct NodePlace {
  int node = 0;
  float beyond = 0;
};
inline NodePlace node_place(float x, int count) {
  const float last = static_cast<float>(count - 1);
  const float at = std::min(std::max(0.0F, x), 1.0F) * last;
  const float node = std::min(std::floor(at), last - 1.0F);
  return {static_cast<int>(node), at - node};
}

// Rows are even in roughness; between them, albedos go with its square.
inline NodePlace alpha_place(float alpha, int count) {
  const NodePlace place = node_place(std::sqrt(std::max(0.0F, alpha)), count);
  const float step = 1.0F / static_cast<float>(count - 1);
  const float first = static_cast<float>(place.node) * step;
  const float beyond = (alpha - first * first) / (step * (2.0F * first + step));
  return {place.node, std::min(std::max(0.0F, beyond), 1.0F)};
}

template <class Values>
inline float between(const Values& values, int stride, NodePlace column, NodePlace row) {
  const int first = row.node * stride + column.node;
  const auto at = [&](int i) { return values[static_cast<std::size_t>(first + i)]; };
  const float here = at(0) + (at(1) - at(0)) * column.beyond;
  const float there = at(stride) + (at(stride + 1) - at(stride)) * column.beyond;
  return here + (there - here) * row.beyond;
}

inline float between(const FacetAlbedoTable::Cells& cells, NodePlace column, NodePlace row) {
  const int at = row.node * (FacetAlbedoTable::cosines - 1) + column.node;
  const std::uint64_t cell = cells[static_cast<std::size_t>(at)];
  const auto corner = [&](unsigned i) {
    return static_cast<float>(static_cast<std::int32_t>((cell >> (16U * i)) & 0xffffU));
  };
  const float here = corner(0) + (corner(1) - corner(0)) * column.beyond;
  const float there = corner(2) + (corner(3) - corner(2)) * column.beyond;
  return (here + (there - here) * row.beyond) * (1.0F / 65535.0F);
}

// Without branches, for loops over lanes.
inline FacetAlbedo facet_albedo(const FacetAlbedoTable& table, float cos_view, float alpha) {
  const float a = std::max(smallest_alpha, alpha);
  const NodePlace row = alpha_place(a, table.roughnesses);
  const NodePlace from_edge = node_place(cos_view * (1.0F + a) / (cos_view + a), table.cosines);
  const NodePlace column = node_place(std::sqrt(std::max(0.0F, cos_view)), table.cosines);
  const float all = between(table.all, from_edge, row);
  const float share = between(table.share, column, row);
  const bool smooth = alpha < smallest_alpha;
  return {smooth ? 1.0F : all, smooth ? schlick(cos_view) : all * share};
}

// Of microfacets that reflect by Fresnel's equations, and let the rest through into what has this index
// of refraction, relative to the view's side; both once.
float glass_albedo(float cos_view, float alpha, float eta);

// Of white fibres (`alpha`: sheen roughness squared).
float fibre_albedo(float cos_view, float alpha);

}  // namespace restframe

#include "tracer/bsdf_albedo.h"

#include <vector>

#include "physics/clones.h"
#include "tracer/bsdf_sheen.h"

namespace restframe {
namespace {

// One of those that stand for visible microfacets, as a point of the unit disc.
struct DiscPoint {
  float x, y, weight;
};

// Evenly distributed (Fibonacci's lattice), but closest to the rim, where distributions have their
// tails. What is integrated is the same on both sides of the plane of view and normal: one is enough.
std::vector<DiscPoint> disc_points(int count) {
  constexpr double golden = 0.6180339887498949;
  std::vector<DiscPoint> points;
  for (int i = 0; i < count; ++i) {
    const float left = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    const float radius = std::sqrt(1.0F - left * left * left);
    const double turn = i * golden;
    const float phi = pi * (static_cast<float>(turn - std::floor(turn)) - 0.5F);
    points.push_back({radius * std::cos(phi), radius * std::sin(phi), left * left});
  }
  float sum = 0;
  for (const DiscPoint& point : points) sum += point.weight;
  for (DiscPoint& point : points) point.weight /= sum;
  return points;
}

// In the plane of x and z.
struct View {
  float sine, cosine, lambda, alpha;
};

View view_at(float cosine, float alpha) {
  return {std::sqrt(std::max(0.0F, 1.0F - squared(cosine))), cosine, smith_lambda(cosine, alpha),
          alpha};
}

struct Facet {
  Vec3f normal;
  float cos_half;  // of view and microfacet
};

// As visible_microfacet() in bsdf_sample.h.
inline Facet facet_at(const View& view, const DiscPoint& point) {
  const float length = std::sqrt(squared(view.alpha * view.sine) + squared(view.cosine));
  const float sine = view.alpha * view.sine / length;
  const float cosine = view.cosine / length;
  const float rim = std::sqrt(1.0F - squared(point.x));
  const float y = rim + (point.y - rim) * 0.5F * (1.0F + cosine);
  const float z = std::sqrt(std::max(0.0F, 1.0F - squared(point.x) - squared(y)));
  const Vec3f n(view.alpha * (z * sine - y * cosine), view.alpha * point.x,
                std::max(1e-6F, y * sine + z * cosine));
  const Vec3f normal = n / std::sqrt(glm::dot(n, n));
  return {normal, view.sine * normal.x + view.cosine * normal.z};
}

// Of what microfacets send along a direction at this cosine, the part that no other one stops; nothing
// below the horizon.
inline float let_go(const View& view, float cosine) {
  const float lambda = smith_lambda(std::max(least_cosine, cosine), view.alpha);
  const float part = (1.0F + view.lambda) / (1.0F + view.lambda + lambda);
  return cosine > 0.0F ? part : 0.0F;
}

float at_node(int node, int count) {
  return static_cast<float>(node) / static_cast<float>(count - 1);
}

float node_alpha(int node, int count) {
  return std::max(smallest_alpha, squared(at_node(node, count)));
}

constexpr int cosines = FacetAlbedoTable::cosines;

struct FacetRow {
  float all[cosines] = {}, grazing[cosines] = {};
};

RESTFRAME_CLONES void integrate_facets(const View (&views)[cosines],
                                       const std::vector<DiscPoint>& points, FacetRow& sums) {
  for (const DiscPoint& p : points) {
    const DiscPoint point = p;
#pragma GCC ivdep
    for (int i = 0; i < cosines; ++i) {
      const View view = views[i];
      const Facet facet = facet_at(view, point);
      const float cos_light = 2.0F * facet.cos_half * facet.normal.z - view.cosine;
      const float scattered = point.weight * let_go(view, cos_light);
      sums.all[i] += scattered;
      sums.grazing[i] += scattered * schlick(facet.cos_half);
    }
  }
}

using FacetNodes = std::array<float, std::size_t{cosines} * FacetAlbedoTable::roughnesses>;

// The corners of a cell, from the node of the least cosine and roughness on.
FacetAlbedoTable::Cells packed(const FacetNodes& nodes) {
  FacetAlbedoTable::Cells cells{};
  constexpr std::size_t columns = cosines - 1;
  for (std::size_t at = 0; at < cells.size(); ++at) {
    const std::size_t first = at / columns * cosines + at % columns;
    const std::size_t corners[] = {first, first + 1, first + cosines, first + cosines + 1};
    for (std::size_t i = 0; i < 4; ++i) {
      const float value = std::min(std::max(0.0F, nodes[corners[i]]), 1.0F);
      cells[at] |= static_cast<std::uint64_t>(std::lround(value * 65535.0F)) << (16 * i);
    }
  }
  return cells;
}

FacetAlbedoTable tabulate_facets() {
  FacetNodes all_nodes{}, share_nodes{};
  const std::vector<DiscPoint> points = disc_points(377);
  for (int row = 0; row < FacetAlbedoTable::roughnesses; ++row) {
    const float alpha = node_alpha(row, FacetAlbedoTable::roughnesses);
    View from_edge[cosines], even[cosines];
    for (int i = 0; i < cosines; ++i) {
      const float x = at_node(i, cosines);
      from_edge[i] = view_at(std::max(least_cosine, x * alpha / (1.0F + alpha - x)), alpha);
      even[i] = view_at(std::max(least_cosine, x * x), alpha);
    }
    FacetRow all, share;
    integrate_facets(from_edge, points, all);
    integrate_facets(even, points, share);
    const auto first = static_cast<std::size_t>(row * cosines);
    for (std::size_t i = 0; i < static_cast<std::size_t>(cosines); ++i) {
      all_nodes[first + i] = all.all[i];
      share_nodes[first + i] = share.grazing[i] / share.all[i];
    }
  }
  return {packed(all_nodes), packed(share_nodes)};
}

// Indices are even in the signed root of (eta - 1) / (eta + 1), up to about 10 and its inverse.
struct GlassAlbedoTable {
  static constexpr int cosines = 21, roughnesses = 13, indices = 33;
  static constexpr float greatest = 0.9F;
  using Layer = std::array<float, static_cast<std::size_t>(cosines) * roughnesses>;
  std::array<Layer, indices> layers;
};

float glass_coordinate(float eta) {
  const float root = (eta - 1.0F) / (eta + 1.0F);
  return std::copysign(std::sqrt(std::abs(root)), root);
}

float node_index(int node) {
  const float y = (2.0F * at_node(node, GlassAlbedoTable::indices) - 1.0F);
  const float root = y * std::abs(y) * squared(GlassAlbedoTable::greatest);
  return (1.0F + root) / (1.0F - root);
}

struct GlassColumn {
  float all[GlassAlbedoTable::indices] = {};
};

// The refracted direction's cosine is that of Snell's law at the microfacet.
RESTFRAME_CLONES void integrate_glass(const View& seen,
                                      const float (&etas)[GlassAlbedoTable::indices],
                                      const std::vector<DiscPoint>& points, GlassColumn& sums) {
  const View view = seen;
  for (const DiscPoint& p : points) {
    const DiscPoint point = p;
    const Facet facet = facet_at(view, point);
    const float mirrored = let_go(view, 2.0F * facet.cos_half * facet.normal.z - view.cosine);
#pragma GCC ivdep
    for (int i = 0; i < GlassAlbedoTable::indices; ++i) {
      const float eta = etas[i];
      const float reflectance = reflected_fraction(facet.cos_half, eta);
      const float cos2_beyond = 1.0F - (1.0F - squared(facet.cos_half)) / squared(eta);
      const float cos_beyond = std::sqrt(std::max(0.0F, cos2_beyond));
      const float cosine = (facet.cos_half / eta - cos_beyond) * facet.normal.z - view.cosine / eta;
      const float refracted = let_go(view, -cosine);
      sums.all[i] += point.weight * (reflectance * mirrored + (1.0F - reflectance) * refracted);
    }
  }
}

GlassAlbedoTable tabulate_glass() {
  using Table = GlassAlbedoTable;
  Table table{};
  const std::vector<DiscPoint> points = disc_points(377);
  float etas[Table::indices];
  for (int i = 0; i < Table::indices; ++i) etas[i] = node_index(i);
  std::size_t at = 0;
  for (int row = 0; row < Table::roughnesses; ++row) {
    for (int column = 0; column < Table::cosines; ++column, ++at) {
      const float alpha = node_alpha(row, Table::roughnesses);
      const float x = at_node(column, Table::cosines);
      const float cosine = std::max(least_cosine, x * alpha / (1.0F + alpha - x));
      GlassColumn sums;
      integrate_glass(view_at(cosine, alpha), etas, points, sums);
      for (std::size_t i = 0; i < table.layers.size(); ++i) table.layers[i][at] = sums.all[i];
    }
  }
  return table;
}

struct FibreAlbedoTable {
  static constexpr int cosines = 25, roughnesses = 17;
  std::array<float, static_cast<std::size_t>(cosines) * roughnesses> all;
};

// Over the hemisphere, closest near the horizon, where they shine.
float integrate_fibres(float cosine, float alpha) {
  constexpr int rings = 24, sectors = 16;
  const View view = view_at(cosine, alpha);
  const Fibres fibres{{0, 0, 1}, {view.sine, 0, cosine}, alpha, cosine};
  float sum = 0;
  for (int i = 0; i < rings; ++i) {
    const float x = (static_cast<float>(i) + 0.5F) / rings;
    const float ring = 2.0F * x / rings;  // of the cosine x^2
    for (int j = 0; j < sectors; ++j) {
      const float phi = pi * (static_cast<float>(j) + 0.5F) / sectors;
      const float sine = std::sqrt(1.0F - squared(squared(x)));
      sum += ring * (2.0F * pi / sectors) *
             fibre_fraction(fibres, {sine * std::cos(phi), sine * std::sin(phi), squared(x)});
    }
  }
  return sum;
}

FibreAlbedoTable tabulate_fibres() {
  using Table = FibreAlbedoTable;
  Table table{};
  std::size_t at = 0;
  for (int row = 0; row < Table::roughnesses; ++row) {
    for (int column = 0; column < Table::cosines; ++column, ++at) {
      table.all[at] =
          integrate_fibres(std::max(least_cosine, squared(at_node(column, Table::cosines))),
                           node_alpha(row, Table::roughnesses));
    }
  }
  return table;
}

}  // namespace

const FacetAlbedoTable& facet_albedo_table() {
  static const FacetAlbedoTable table = tabulate_facets();
  return table;
}

float glass_albedo(float cos_view, float alpha, float eta) {
  using Table = GlassAlbedoTable;
  static const Table table = tabulate_glass();
  const float a = std::max(smallest_alpha, alpha);
  const NodePlace column = node_place(cos_view * (1.0F + a) / (cos_view + a), Table::cosines);
  const NodePlace row = alpha_place(a, Table::roughnesses);
  const NodePlace layer =
      node_place(0.5F + 0.5F * glass_coordinate(eta) / Table::greatest, Table::indices);
  const auto at = [&](int i) {
    return between(table.layers[static_cast<std::size_t>(layer.node + i)], Table::cosines, column,
                   row);
  };
  return glm::mix(at(0), at(1), layer.beyond);
}

float fibre_albedo(float cos_view, float alpha) {
  using Table = FibreAlbedoTable;
  static const Table table = tabulate_fibres();
  return between(table.all, Table::cosines,
                 node_place(std::sqrt(std::max(0.0F, cos_view)), Table::cosines),
                 alpha_place(alpha, Table::roughnesses));
}

}  // namespace restframe

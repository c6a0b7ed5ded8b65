#include "importers/gltf_primitive.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "importers/gltf_accessor.h"
#include "importers/gltf_layout.h"

namespace restframe {
namespace {

// The accessor of an attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

std::size_t accessor_count(const tinygltf::Model& model, int accessor) {
  return model.accessors[static_cast<std::size_t>(accessor)].count;
}

std::size_t corner_count(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  return accessor_count(
      model, primitive.indices >= 0 ? primitive.indices : attribute(primitive, "POSITION"));
}

// The value that glTF keeps from indices of this type: all bits set.
std::uint32_t restart_value(int component_type) {
  switch (component_type) {
    case component_u8:
      return std::numeric_limits<std::uint8_t>::max();
    case component_u16:
      return std::numeric_limits<std::uint16_t>::max();
    default:
      return std::numeric_limits<std::uint32_t>::max();
  }
}

// The vertices of a primitive's corners, in its order; `corners` has room for all.
void read_corners(const PrimitivePlace& place, const tinygltf::Model& model, int accessor,
                  std::size_t count, std::size_t vertices, std::uint32_t* corners) {
  if (accessor < 0) {
    for (std::size_t i = 0; i < count; ++i) corners[i] = static_cast<std::uint32_t>(i);
    return;
  }
  read_indices(place.context, model, accessor, corners);
  const int type = model.accessors[static_cast<std::size_t>(accessor)].componentType;
  check_indices(place, corners, count, vertices, restart_value(type));
}

void warn_of_rest(const PrimitivePlace& place, std::size_t corners) {
  place.context.warn(place.pointer, std::to_string(corners) +
                                        " corners after the last whole triangle are left out");
}

// Strips and fans; the triangles without area that join the pieces of strips are left out.
std::vector<Triangle> unroll(const std::vector<std::uint32_t>& corners, bool fan,
                             std::size_t room) {
  std::vector<Triangle> triangles;
  triangles.reserve(std::max(corners.size(), room));
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::size_t odd = i % 2;
    const Triangle triangle =
        fan ? Triangle{corners[0], corners[i - 1], corners[i]}
            : Triangle{corners[i - 2 + odd], corners[i - 1 - odd], corners[i]};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      continue;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<Triangle> read_triangles(const PrimitivePlace& place, const tinygltf::Model& model,
                                     const tinygltf::Primitive& primitive, std::size_t vertices,
                                     std::size_t room) {
  const std::size_t corners = corner_count(model, primitive);
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
    // Three corners a triangle, straight into the mesh.
    std::vector<Triangle> triangles;
    triangles.reserve(std::max((corners + 2) / 3, room));
    triangles.resize((corners + 2) / 3);
    read_corners(place, model, primitive.indices, corners, vertices, triangles.data()->data());
    triangles.resize(corners / 3);
    if (corners % 3 != 0) warn_of_rest(place, corners % 3);
    return triangles;
  }
  if (corners < 3) warn_of_rest(place, corners);
  std::vector<std::uint32_t> strip(corners);
  read_corners(place, model, primitive.indices, corners, vertices, strip.data());
  return unroll(strip, primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN, room);
}

std::vector<Vec4f> read_colors(const PrimitivePlace& place, const tinygltf::Model& model,
                               int accessor, const Wanted& wanted) {
  std::vector<Vec4f> colors = read_vec4(place.context, model, accessor, wanted);
  if (model.accessors[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC3) {
    for (Vec4f& color : colors) color.w = 1;
  }
  return colors;
}

// The attributes besides positions. Tangents without normals mean nothing, and are left out.
void read_attributes(const PrimitivePlace& place, const tinygltf::Model& model,
                     const tinygltf::Primitive& primitive, const Wanted& wanted, Mesh& mesh) {
  const int normals = attribute(primitive, "NORMAL"), tangents = attribute(primitive, "TANGENT"),
            colors = attribute(primitive, "COLOR_0");
  if (normals >= 0) mesh.normals = read_vec3(place.context, model, normals, wanted);
  if (normals >= 0 && tangents >= 0) {
    mesh.tangents = read_vec4(place.context, model, tangents, wanted);
  }
  for (std::size_t set = 0;; ++set) {
    const int uvs = attribute(primitive, "TEXCOORD_" + std::to_string(set));
    if (uvs < 0) break;
    if (set >= mesh.uvs.size()) mesh.uvs.emplace_back();
    mesh.uvs[set] = read_vec2(place.context, model, uvs, wanted);
  }
  if (colors >= 0) mesh.colors = read_colors(place, model, colors, wanted);
}

Mesh read_vertices(const PrimitivePlace& place, const tinygltf::Model& model,
                   const tinygltf::Primitive& primitive, const Wanted& wanted) {
  Mesh mesh;
  mesh.positions = read_vec3(place.context, model, attribute(primitive, "POSITION"), wanted);
  check_positions(place, mesh.positions);
  read_attributes(place, model, primitive, wanted, mesh);
  return mesh;
}

bool has_sparse(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  for (const auto& [name, accessor] : primitive.attributes) {
    if (model.accessors[static_cast<std::size_t>(accessor)].sparse.isSparse) return true;
  }
  return false;
}

// Reports faults of vertices whether or not a triangle uses them. In blocks, which take next to no
// memory; but sparse values, which each block would have to go through, all at once.
void check_all_vertices(const PrimitivePlace& place, const tinygltf::Model& model,
                        const tinygltf::Primitive& primitive, std::size_t count) {
  const std::size_t block = has_sparse(model, primitive) ? count : std::size_t{16384};
  std::vector<std::uint32_t> numbers;
  for (std::size_t first = 0; first < count; first += block) {
    numbers.resize(std::min(block, count - first));
    std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
    const Wanted wanted{&numbers, 0};
    Mesh mesh;
    mesh.positions = read_vec3(place.context, model, attribute(primitive, "POSITION"), wanted);
    check_positions(place, mesh.positions, first);
    read_attributes(place, model, primitive, wanted, mesh);
    check_attributes(place, mesh, first);
  }
}

// Triangles of a mirrored mesh turn their other side to us.
void turn_over(std::vector<Triangle>& triangles) {
  for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
}

// Poses its vertices, and mends what need not stop the import.
void finish(const PrimitivePlace& place, const tinygltf::Model& model,
            const tinygltf::Primitive& primitive, const PosedMesh& posed, Skins& skins,
            Mesh& mesh) {
  add_targets(place, model, primitive, posed.weights, mesh);
  check_attributes(place, mesh);
  for (Vec4f& color : mesh.colors) color = glm::clamp(color, 0.0F, 1.0F);  // glTF 2.0, 3.7.2.1
  mend_normals(place, mesh);
  mend_tangents(place, mesh);
  if (posed.skin >= 0) {
    apply_skin(place, model, primitive, skins.matrices(posed.skin), mesh);
  }
  check_positions(place, mesh.positions);
  if (posed.mirrored) turn_over(mesh.triangles);
}

}  // namespace

bool is_surface(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

WholeMesh whole_of(const GltfContext& context, const tinygltf::Model& model,
                   const tinygltf::Mesh& mesh) {
  WholeMesh whole;
  std::vector<const tinygltf::Primitive*> surfaces;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    if (is_surface(primitive)) surfaces.push_back(&primitive);
  }
  whole.shares_vertices = surfaces.size() > 1;
  for (const tinygltf::Primitive* primitive : surfaces) {
    const std::size_t corners = corner_count(model, *primitive);
    whole.triangles += primitive->mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners;
    const std::size_t vertices = accessor_count(model, attribute(*primitive, "POSITION"));
    whole.vertices += whole.shares_vertices && primitive->indices >= 0
                          ? count_indices(context, model, primitive->indices, vertices)
                          : std::min(corners, vertices);
  }
  return whole;
}

Mesh read_primitive(const PrimitivePlace& place, const tinygltf::Model& model,
                    const tinygltf::Primitive& primitive, const PosedMesh& posed, Skins& skins,
                    const WholeMesh& whole) {
  const std::size_t vertices = accessor_count(model, attribute(primitive, "POSITION"));
  std::vector<Triangle> triangles =
      read_triangles(place, model, primitive, vertices, whole.triangles);
  const bool may_leave_out = whole.shares_vertices || 3 * triangles.size() < vertices;
  const bool is_posed = posed.skin >= 0 || !posed.weights.empty();  // reads more than attributes
  std::vector<std::uint32_t> used;
  Wanted wanted{nullptr, whole.vertices};
  if (may_leave_out && !is_posed) {
    used = renumber_used(triangles);
    if (used.size() < vertices) {
      check_all_vertices(place, model, primitive, vertices);
      wanted.elements = &used;
    }
  }
  Mesh mesh = read_vertices(place, model, primitive, wanted);
  mesh.triangles = std::move(triangles);
  finish(place, model, primitive, posed, skins, mesh);
  if (may_leave_out && is_posed) drop_unused_vertices(mesh);
  return mesh;
}

}  // namespace restframe

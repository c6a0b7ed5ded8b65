#include "importers/gltf_mesh.h"

#include "importers/gltf_accessor.h"
#include "importers/gltf_geometry.h"

namespace restframe {
namespace {

bool is_surface(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

// The accessor of an attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const char* name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

// Three corners a triangle, straight into the mesh; a rest of one or two corners is left out.
std::vector<Triangle> read_list(const PrimitivePlace& place, const tinygltf::Model& model,
                                int accessor, std::size_t corners) {
  std::vector<Triangle> triangles((corners + 2) / 3);
  if (accessor >= 0) {
    read_indices(place.context, model, accessor, triangles.data()->data());
  } else {
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
      triangles[i / 3][i % 3] = static_cast<std::uint32_t>(i);
    }
  }
  triangles.resize(corners / 3);
  if (corners % 3 != 0) {
    place.context.warn(place.pointer, std::to_string(corners % 3) +
                                          " corners after the last whole triangle are left out");
  }
  return triangles;
}

// Strips and fans; the triangles without area that join the pieces of strips are left out.
std::vector<Triangle> unroll(const std::vector<std::uint32_t>& corners, bool fan) {
  std::vector<Triangle> triangles;
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
                                     const tinygltf::Primitive& primitive, std::size_t vertices) {
  const int accessor = primitive.indices;
  const std::size_t corners =
      accessor >= 0 ? model.accessors[static_cast<std::size_t>(accessor)].count : vertices;
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) return read_list(place, model, accessor, corners);
  std::vector<std::uint32_t> strip(corners);
  if (accessor >= 0) {
    read_indices(place.context, model, accessor, strip.data());
  } else {
    for (std::size_t i = 0; i < corners; ++i) strip[i] = static_cast<std::uint32_t>(i);
  }
  return unroll(strip, primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN);
}

std::vector<Vec4f> read_colors(const PrimitivePlace& place, const tinygltf::Model& model,
                               int accessor) {
  std::vector<Vec4f> colors = read_vec4(place.context, model, accessor);
  if (model.accessors[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC3) {
    for (Vec4f& color : colors) color.w = 1;
  }
  return colors;
}

Mesh read_primitive(const PrimitivePlace& place, const tinygltf::Model& model,
                    const tinygltf::Primitive& primitive, bool shares_vertices) {
  Mesh mesh;
  mesh.positions = read_vec3(place.context, model, attribute(primitive, "POSITION"));
  check_positions(place, mesh.positions);
  mesh.triangles = read_triangles(place, model, primitive, mesh.positions.size());
  check_indices(place, mesh.triangles, mesh.positions.size());
  const int normals = attribute(primitive, "NORMAL"), colors = attribute(primitive, "COLOR_0");
  const std::array<int, 2> uvs = {attribute(primitive, "TEXCOORD_0"),
                                  attribute(primitive, "TEXCOORD_1")};
  if (normals >= 0) mesh.normals = read_vec3(place.context, model, normals);
  for (std::size_t set = 0; set < uvs.size(); ++set) {
    if (uvs[set] >= 0) mesh.uvs[set] = read_vec2(place.context, model, uvs[set]);
  }
  if (colors >= 0) mesh.colors = read_colors(place, model, colors);
  check_attributes(place, mesh);
  if (shares_vertices || 3 * mesh.triangles.size() < mesh.positions.size()) {
    drop_unused_vertices(mesh);
  }
  mend_normals(place, mesh);
  return mesh;
}

}  // namespace

Mesh read_mesh(const GltfContext& context, const tinygltf::Model& model, std::size_t index,
               const std::vector<int>& slots) {
  const std::vector<tinygltf::Primitive>& primitives = model.meshes[index].primitives;
  const std::string pointer = "/meshes/" + std::to_string(index);
  std::size_t surfaces = 0;
  bool any_normals = false;
  for (const tinygltf::Primitive& primitive : primitives) {
    surfaces += is_surface(primitive);
    any_normals |= is_surface(primitive) && attribute(primitive, "NORMAL") >= 0;
  }
  Mesh mesh;
  bool first = true;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (!is_surface(primitives[i])) continue;
    const PrimitivePlace place{context, pointer + "/primitives/" + std::to_string(i)};
    Mesh part = read_primitive(place, model, primitives[i], surfaces > 1);
    if (part.triangles.empty()) continue;
    if (any_normals && part.normals.empty()) add_normals(part);
    const int slot = slots[i];
    if (first) {
      mesh = std::move(part);
      mesh.materials = {{0, slot}};
    } else {
      append(mesh, part, slot);
    }
    first = false;
  }
  if (!any_normals && !mesh.triangles.empty()) add_normals(mesh);
  mesh.name = model.meshes[index].name;
  if (mesh.name.empty()) mesh.name = "mesh_" + std::to_string(index);
  if (surfaces < primitives.size()) {
    context.warn(pointer, std::to_string(primitives.size() - surfaces) +
                              " primitives of points or lines are not renderable, skipped");
  }
  pad_for_embree(mesh);
  return mesh;
}

}  // namespace restframe

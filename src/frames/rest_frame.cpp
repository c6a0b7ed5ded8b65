#include "frames/rest_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace restframe {
namespace {

Vec3 transformed(const Mat4& m, const Vec3& p) {
  return Vec3(m * glm::dvec4(p, 1.0));
}

Bounds transformed(const Mat4& m, const Bounds& b) {
  Bounds result;
  for (int corner = 0; corner < 8; ++corner) {
    result.add(transformed(m, Vec3((corner & 1) != 0 ? b.upper.x : b.lower.x,
                                   (corner & 2) != 0 ? b.upper.y : b.lower.y,
                                   (corner & 4) != 0 ? b.upper.z : b.lower.z)));
  }
  return result;
}

// A hit that float rounding puts on a face of the bounds must still lie within them.
Bounds padded(const Bounds& b) {
  const double margin = 1e-6 * (glm::length(b.extent()) + glm::length(b.center()));
  return {b.lower - Vec3(margin), b.upper + Vec3(margin)};
}

Mat4 translation(const Vec3& offset) {
  return glm::translate(Mat4(1), offset);
}

std::vector<Vec3f> baked_positions(const Mat4& to, std::span<const Vec3f> positions) {
  std::vector<Vec3f> result;
  result.reserve(positions.size() + 1);  // Embree reads 16 bytes a vertex
  for (const Vec3f& p : positions) result.emplace_back(transformed(to, Vec3(p)));
  return result;
}

// Whether directions of one octant have images of one octant: a scaling, with axes exchanged or mirrored.
bool keeps_octants(const Mat3& linear) {
  for (int row = 0; row < 3; ++row) {
    int entries = 0;
    for (int column = 0; column < 3; ++column) entries += linear[column][row] != 0.0 ? 1 : 0;
    if (entries != 1) return false;
  }
  return true;
}

double largest_entry(const Mat3& m) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  }
  return largest;
}

// The inverse transpose, its largest entry brought to 1 or -1: however small or large the mesh is placed,
// floats hold it and the squares of what it gives.
glm::mat3 normal_matrix(const Mat3& linear) {
  const Mat3 m = glm::transpose(glm::inverse(linear));
  return glm::mat3(m / largest_entry(m));
}

// Triangles much smaller or larger than this, in traversal coordinates, are lost in Embree's floats.
double traversal_unit(const Bounds& bounds) {
  constexpr double smallest = 1e-2;
  constexpr double largest = 1e6;
  const double size = glm::length(bounds.extent());
  return size == 0.0 || (size > smallest && size < largest) ? 1.0 : size;
}

// Embree scales a ray's direction by the inverse, which its asserts bear up to 1.8e18.
bool can_be_instanced(const Mat4& traversal_from_local) {
  constexpr double greatest_ratio = 1e9;
  const Mat3 linear(traversal_from_local);
  for (int column = 0; column < 3; ++column) {
    const double length = glm::length(linear[column]);
    if (!(length > 1.0 / greatest_ratio && length < greatest_ratio)) return false;
  }
  return std::abs(glm::determinant(linear)) >
         1.0 / greatest_ratio / greatest_ratio / greatest_ratio;
}

EmbreeGeometry instance_geometry(const EmbreeDevice& device, RTCScene instanced, const Mat4& to) {
  EmbreeGeometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(geometry.get(), instanced);
  const glm::mat4x3 columns{glm::mat4(to)};
  rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &columns[0][0]);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace

RestFrame::RestFrame(const EmbreeDevice& device, const Scene& scene, std::span<const int> objects,
                     std::span<const TraversableMesh> meshes, std::span<const int> uses_of_mesh)
    : coordinates_(scene.objects[static_cast<std::size_t>(objects[0])].worldline.rest_frame()) {
  for (const int index : objects) {
    const Object& object = scene.objects[static_cast<std::size_t>(index)];
    for (const PlacedMesh& placed : object.parts) {
      FramePart part;
      part.object = index;
      part.name = placed.name;
      part.mesh = placed.mesh;
      part.triangles = scene.meshes[static_cast<std::size_t>(placed.mesh)].triangles;
      part.met_triangles = meshes[static_cast<std::size_t>(placed.mesh)].met_triangles;
      part.rest_from_mesh = translation(origin_of(object)) * placed.object_from_mesh;
      part.rest_from_mesh_normal = normal_matrix(Mat3(part.rest_from_mesh));
      part.rest_from_facet_normal = part.rest_from_mesh_normal;
      parts_.push_back(std::move(part));
    }
  }
  if (parts_.size() == 1) {
    build_single(meshes);
  } else {
    build_many(device, meshes, uses_of_mesh);
  }
  set_noise_at_end();
}

void RestFrame::build_single(std::span<const TraversableMesh> meshes) {
  FramePart& part = parts_[0];
  const TraversableMesh& mesh = meshes[static_cast<std::size_t>(part.mesh)];
  set_traversal(part.rest_from_mesh * translation(mesh.offset));
  part.positions = mesh.positions();
  traversed_ = mesh.scene.get();
  bounds_ = padded(mesh.bounds);
}

void RestFrame::build_many(const EmbreeDevice& device, std::span<const TraversableMesh> meshes,
                           std::span<const int> uses_of_mesh) {
  Bounds rest_bounds;
  for (const FramePart& part : parts_) {
    const TraversableMesh& mesh = meshes[static_cast<std::size_t>(part.mesh)];
    const Bounds b = transformed(part.rest_from_mesh * translation(mesh.offset), mesh.bounds);
    rest_bounds.add(b.lower);
    rest_bounds.add(b.upper);
  }
  const Vec3 center = parts_.empty() ? Vec3(0) : rest_bounds.center();
  const double unit = traversal_unit(rest_bounds);
  set_traversal(glm::scale(translation(center), Vec3(unit)));
  bounds_ = padded({(rest_bounds.lower - center) / unit, (rest_bounds.upper - center) / unit});
  const Mat4 traversal_from_rest = glm::scale(Mat4(1), Vec3(1.0 / unit)) * translation(-center);

  own_scene_ = new_scene(device);
  traversed_ = own_scene_.get();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    FramePart& part = parts_[i];
    const TraversableMesh& mesh = meshes[static_cast<std::size_t>(part.mesh)];
    part.traversal_from_local =
        traversal_from_rest * part.rest_from_mesh * translation(mesh.offset);
    EmbreeGeometry geometry;
    if (uses_of_mesh[static_cast<std::size_t>(part.mesh)] > 1 &&
        can_be_instanced(part.traversal_from_local)) {
      part.instanced = true;
      has_instances_ = true;
      octants_hold_ = octants_hold_ && keeps_octants(Mat3(part.traversal_from_local));
      part.positions = mesh.positions();
      geometry = instance_geometry(device, mesh.scene.get(), part.traversal_from_local);
    } else {
      part.baked = baked_positions(part.traversal_from_local, mesh.positions());
      part.positions = part.baked;
      // Baked corners give the normal in rest-frame axes; a mirroring has turned it to the back.
      const bool mirrored = glm::determinant(Mat3(part.rest_from_mesh)) < 0.0;
      part.rest_from_facet_normal = glm::mat3(mirrored ? -1.0F : 1.0F);
      geometry = triangle_geometry(device, part.positions, *mesh.mesh);
    }
    rtcAttachGeometryByID(own_scene_.get(), geometry.get(), static_cast<unsigned>(i));
  }
  rtcCommitScene(own_scene_.get());
  device.check();
}

void RestFrame::set_noise_at_end() {
  constexpr double float_noise = 16.0 * 0x1p-24;
  const double reach = glm::length(bounds_.center()) + 0.5 * glm::length(bounds_.extent());
  noise_at_end_ = float_noise * reach / traversal_scale_;
}

void RestFrame::set_traversal(const Mat4& rest_from_traversal) {
  rest_from_traversal_linear_ = Mat3(rest_from_traversal);
  rest_from_traversal_offset_ = Vec3(rest_from_traversal[3]);
  traversal_from_rest_linear_ = glm::inverse(rest_from_traversal_linear_);
  traversal_scale_ = largest_entry(traversal_from_rest_linear_);
  traversal_is_turned_ = rest_from_traversal_linear_ != Mat3(1);
}

double RestFrame::clock_at_anchor(const Object& object) const {
  // The frame's own time is 0 at the world's origin event; it is the anchor's there, seen from that
  // event.
  if (object.frame_clock)
    return coordinates_.from_world(coordinates_.anchor - Event<in::World>{}).t;
  return object.clock - coordinates_(object.worldline.reference).t;
}

}  // namespace restframe

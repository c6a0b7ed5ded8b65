#include "app/info_words.h"

#include <fmt/format.h>

#include <array>

#include "scene/mesh_closed.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

constexpr std::size_t most_vertices = 50'000'000;  // to look at for bounds

template <class T>
std::size_t bytes(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

const Mesh& mesh_of(const std::vector<Mesh>& meshes, const PlacedMesh& part) {
  return meshes[static_cast<std::size_t>(part.mesh)];
}

Bounds bounds_of_boxes(const std::vector<Mesh>& meshes, const std::vector<PlacedMesh>& parts) {
  std::vector<Bounds> boxes;
  boxes.reserve(meshes.size());
  for (const Mesh& mesh : meshes) boxes.push_back(bounds_of(mesh));
  Bounds all;
  for (const PlacedMesh& part : parts) {
    const Bounds& box = boxes[static_cast<std::size_t>(part.mesh)];
    for (int corner = 0; corner < 8 && !box.empty(); ++corner) {
      const glm::dvec4 p((corner & 1) != 0 ? box.upper.x : box.lower.x,
                         (corner & 2) != 0 ? box.upper.y : box.lower.y,
                         (corner & 4) != 0 ? box.upper.z : box.lower.z, 1);
      all.add(Vec3(part.object_from_mesh * p));
    }
  }
  return all;
}

}  // namespace

std::string text_of(const Vec3& v) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x, v.y, v.z);
}

std::string count_of(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string size_text(double bytes) {
  constexpr std::array units = {"bytes", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  return unit == 0 ? fmt::format("{:.0f} bytes", bytes)
                   : fmt::format("{:.1f} {}", bytes, units[unit]);
}

std::string text_of(const Material& material) {
  const Vec3f& color = material.base_color.value;
  return fmt::format("base color [{:.3g}, {:.3g}, {:.3g}]{}{}{}{}", color.x, color.y, color.z,
                     material.base_color.function == no_function ? "" : ", changes over its clock",
                     material.base_color_texture.texture < 0 ? "" : ", textured",
                     material.alpha_mode == AlphaMode::opaque ? "" : ", transparent",
                     can_transmit(material) ? ", transmits light" : "");
}

const char* kind_name(LightKind kind) {
  constexpr std::array kinds = {"point", "spot", "sun", "environment"};
  return kinds[static_cast<std::size_t>(kind)];
}

std::string shine_text(const Light& light) {
  const Vec3f& color = light.color.value;
  const char* unit = light.kind == LightKind::sun           ? " W/m2"
                     : light.kind == LightKind::environment ? ""
                                                            : " W/sr";
  const std::string intensity = light.intensity.function == no_function
                                    ? fmt::format("{:.6g}{}", light.intensity.value, unit)
                                    : "changes over its clock";
  return fmt::format("color [{:.3g}, {:.3g}, {:.3g}], {}", color.x, color.y, color.z, intensity);
}

std::size_t bytes_in_memory(const Mesh& mesh) {
  std::size_t sum = bytes(mesh.positions) + bytes(mesh.triangles) + bytes(mesh.normals) +
                    bytes(mesh.colors) + bytes(mesh.materials);
  for (const std::vector<Vec2f>& set : mesh.uvs) sum += bytes(set);
  return sum;
}

std::size_t bytes_in_memory(const std::vector<Mesh>& meshes) {
  std::size_t sum = 0;
  for (const Mesh& mesh : meshes) sum += bytes_in_memory(mesh);
  return sum;
}

std::size_t bytes_in_memory(const std::vector<SkyMap>& maps) {
  std::size_t sum = 0;
  for (const SkyMap& map : maps) sum += bytes(map.pixels);
  return sum;
}

std::size_t bytes_in_memory(const std::vector<Image>& images) {
  std::size_t sum = 0;
  for (const Image& image : images) sum += bytes(image.rgba);
  return sum;
}

std::vector<char> closedness_of(const std::vector<Mesh>& meshes) {
  std::vector<char> closed(meshes.size());
  parallel_for(meshes.size(), [&](std::size_t i) { closed[i] = is_closed(meshes[i]); });
  return closed;
}

Bounds bounds_of_placed(const std::vector<Mesh>& meshes, const std::vector<PlacedMesh>& parts) {
  std::size_t vertices = 0;
  for (const PlacedMesh& part : parts) vertices += mesh_of(meshes, part).positions.size();
  if (vertices > most_vertices) return bounds_of_boxes(meshes, parts);
  Bounds all;
  for (const PlacedMesh& part : parts) {
    for (const Vec3f& p : mesh_of(meshes, part).positions) {
      all.add(Vec3(part.object_from_mesh * glm::dvec4(Vec3(p), 1.0)));
    }
  }
  return all;
}

}  // namespace restframe

#include <fmt/format.h>

#include <array>
#include <set>

#include "app/commands.h"
#include "app/messages.h"
#include "frames/frame_set.h"
#include "scene/error.h"
#include "scene/mesh_closed.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

std::size_t triangles_of(const Scene& scene, const Object& object) {
  std::size_t count = 0;
  for (const PlacedMesh& part : object.parts) {
    count += scene.meshes[static_cast<std::size_t>(part.mesh)].triangles.size();
  }
  return count;
}

template <class T>
std::size_t bytes(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

std::size_t mesh_bytes(const Scene& scene) {
  std::size_t sum = 0;
  for (const Mesh& mesh : scene.meshes) sum += bytes_of(mesh);
  return sum;
}

std::size_t image_bytes(const Scene& scene) {
  std::size_t sum = 0;
  for (const Image& image : scene.images) sum += bytes(image.rgba);
  return sum;
}

std::string text_of(const Vec3& v) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", v.x, v.y, v.z);
}

std::string count_of(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

// Of everything in the object, in scene units around its origin.
Bounds object_bounds(const Scene& scene, const Object& object) {
  Bounds all;
  for (const PlacedMesh& part : object.parts) {
    for (const Vec3f& p : scene.meshes[static_cast<std::size_t>(part.mesh)].positions) {
      all.add(Vec3(part.object_from_mesh * glm::dvec4(Vec3(p), 1.0)) * scene.light_speed);
    }
  }
  return all;
}

// Of each mesh, whether it is closed. Bytes, since vector<bool> is none of its type.
using Closedness = std::vector<char>;

Closedness closedness_of(const Scene& scene) {
  Closedness closed(scene.meshes.size());
  parallel_for(scene.meshes.size(), [&](std::size_t i) { closed[i] = is_closed(scene.meshes[i]); });
  return closed;
}

// "closed", as refraction needs it, or what of the object is not.
std::string closedness_of(const Object& object, const Closedness& closed) {
  std::set<int> all, open;
  for (const PlacedMesh& part : object.parts) {
    all.insert(part.mesh);
    if (closed[static_cast<std::size_t>(part.mesh)] == 0) open.insert(part.mesh);
  }
  if (open.empty()) return "closed";
  if (open.size() == all.size()) return "open";
  return fmt::format("{} of {} meshes open", open.size(), all.size());
}

void print_frame(const Scene& scene, const RestFrame& frame, const Closedness& closed,
                 std::size_t number) {
  const Velocity& velocity = frame.coordinates().from_world.velocity();
  fmt::print("rest frame {}: velocity {} c, gamma {:.6g}\n", number, text_of(velocity.beta()),
             velocity.gamma());
  int last = -1;
  for (const FramePart& part : frame.parts()) {
    if (part.object == last) continue;
    last = part.object;
    const Object& object = scene.objects[static_cast<std::size_t>(last)];
    const Bounds bounds = object_bounds(scene, object);
    fmt::print("  {}: {}, {}, {}, {} to {}, size {}, placed at {}\n", object.name,
               count_of(object.parts.size(), "mesh placed", "meshes placed"),
               count_of(triangles_of(scene, object), "triangle", "triangles"),
               closedness_of(object, closed), text_of(bounds.lower), text_of(bounds.upper),
               text_of(bounds.extent()), text_of(object.worldline.reference.x * scene.light_speed));
  }
}

void print_lights(const Scene& scene) {
  constexpr std::array kinds = {"point", "spot", "sun", "environment"};
  for (const Light& light : scene.lights) {
    const Worldline& worldline = light.worldline;
    fmt::print("light {}: {}, velocity {} c, placed at {}\n", light.name,
               kinds[static_cast<std::size_t>(light.kind)], text_of(worldline.velocity.beta()),
               text_of(worldline.reference.x * scene.light_speed));
  }
}

void print_materials(const Scene& scene) {
  for (const Material& m : scene.materials) {
    const Vec3f& color = m.base_color.value;
    const bool transmits = m.transmission.function != no_function || m.transmission.value > 0;
    fmt::print("material {}: base color [{:.3g}, {:.3g}, {:.3g}]{}{}{}{}\n", m.name, color.x,
               color.y, color.z,
               m.base_color.function == no_function ? "" : ", changes over its clock",
               m.base_color_texture.texture < 0 ? "" : ", textured",
               m.alpha_mode == AlphaMode::opaque ? "" : ", transparent",
               transmits ? ", transmits light" : "");
  }
}

}  // namespace

int info(const InfoOptions& options, const ImportLimits& limits) {
  const Scene scene = loaded_scene(options.file, limits);
  const FrameSet frames(scene, thread_count());
  std::size_t stored = 0;
  for (const Mesh& mesh : scene.meshes) stored += mesh.triangles.size();
  fmt::print("{}: {}, {}, {}, {} stored, {}\n", options.file,
             count_of(frames.frames().size(), "rest frame", "rest frames"),
             count_of(scene.objects.size(), "object", "objects"),
             count_of(scene.materials.size(), "material", "materials"),
             count_of(stored, "triangle", "triangles"),
             count_of(scene.images.size(), "image", "images"));
  const Closedness closed = closedness_of(scene);
  std::size_t number = 0;
  for (const RestFrame& frame : frames.frames()) print_frame(scene, frame, closed, ++number);
  print_lights(scene);
  print_materials(scene);
  const auto megabytes = [](std::size_t count) { return static_cast<double>(count) * 1e-6; };
  fmt::print("memory: meshes {:.1f} MB, images {:.1f} MB, Embree {:.1f} MB ({:.1f} MB to build)\n",
             megabytes(mesh_bytes(scene)), megabytes(image_bytes(scene)),
             megabytes(frames.embree_bytes()), megabytes(frames.peak_embree_bytes()));
  return 0;
}

}  // namespace restframe

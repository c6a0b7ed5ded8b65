#include <fmt/format.h>

#include "app/commands.h"
#include "app/messages.h"
#include "frames/frame_set.h"
#include "scene/error.h"
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
  for (const Mesh& m : scene.meshes) {
    sum += bytes(m.positions) + bytes(m.triangles) + bytes(m.normals) + bytes(m.uvs[0]) +
           bytes(m.uvs[1]) + bytes(m.colors);
  }
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

void print_frame(const Scene& scene, const RestFrame& frame, std::size_t number) {
  const Velocity& velocity = frame.coordinates().from_world.velocity();
  fmt::print("rest frame {}: velocity {} c, gamma {:.6g}\n", number, text_of(velocity.beta()),
             velocity.gamma());
  int last = -1;
  for (const FramePart& part : frame.parts()) {
    if (part.object == last) continue;
    last = part.object;
    const Object& object = scene.objects[static_cast<std::size_t>(last)];
    const Bounds bounds = object_bounds(scene, object);
    fmt::print("  {}: {}, {}, {} to {}, size {}, placed at {}\n", object.name,
               count_of(object.parts.size(), "mesh placed", "meshes placed"),
               count_of(triangles_of(scene, object), "triangle", "triangles"),
               text_of(bounds.lower), text_of(bounds.upper), text_of(bounds.extent()),
               text_of(object.worldline.reference.x * scene.light_speed));
  }
}

void print_materials(const Scene& scene) {
  for (const Material& m : scene.materials) {
    const Vec3f& color = m.base_color.value;
    fmt::print("material {}: base color [{:.3g}, {:.3g}, {:.3g}]{}{}{}\n", m.name, color.x, color.y,
               color.z, m.base_color.function == no_function ? "" : ", changes over its clock",
               m.base_color_texture.texture < 0 ? "" : ", textured",
               m.alpha_mode == AlphaMode::opaque ? "" : ", transparent");
  }
}

}  // namespace

int info(const InfoOptions& options, const ImportLimits& limits) {
  Warnings warnings;
  const Scene scene = load_scene(options.file, limits, warnings);
  for (const std::string& warning : warnings) report_warning(warning);
  const std::vector<std::string> faults = validate(scene);
  if (!faults.empty()) throw InputError(options.file + ": " + faults.front());

  const FrameSet frames(scene, thread_count());
  std::size_t stored = 0;
  for (const Mesh& mesh : scene.meshes) stored += mesh.triangles.size();
  fmt::print("{}: {}, {}, {}, {} stored, {}\n", options.file,
             count_of(frames.frames().size(), "rest frame", "rest frames"),
             count_of(scene.objects.size(), "object", "objects"),
             count_of(scene.materials.size(), "material", "materials"),
             count_of(stored, "triangle", "triangles"),
             count_of(scene.images.size(), "image", "images"));
  std::size_t number = 0;
  for (const RestFrame& frame : frames.frames()) print_frame(scene, frame, ++number);
  print_materials(scene);
  const auto megabytes = [](std::size_t count) { return static_cast<double>(count) * 1e-6; };
  fmt::print("memory: meshes {:.1f} MB, images {:.1f} MB, Embree {:.1f} MB ({:.1f} MB to build)\n",
             megabytes(mesh_bytes(scene)), megabytes(image_bytes(scene)),
             megabytes(frames.embree_bytes()), megabytes(frames.peak_embree_bytes()));
  return 0;
}

}  // namespace restframe

#include "app/info.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/asset_report.h"
#include "app/commands.h"
#include "app/info_json.h"
#include "app/info_words.h"
#include "app/job_needs.h"
#include "scene/file_names.h"
#include "scene/message.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

// What info looks at.
struct Inspected {
  Warnings warnings;
  std::vector<AssetReport> assets;  // the file itself, or those of the scene file
  bool is_scene_file = false;
  Scene scene;
};

// The files among the scene's sources that are assets: one for each, and none of those that they
// were read from.
std::vector<std::string> asset_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const SourceFile& source : scene.sources) {
    const std::string extension = lower_extension(source.name);
    const bool is_asset = extension == ".glb" || extension == ".gltf" || extension == ".obj" ||
                          extension == ".ply" || extension == ".stl" || extension == ".off";
    if (is_asset) names.push_back(source.name);
  }
  return names;
}

Inspected inspect(const std::string& file, const ImportLimits& limits) {
  Inspected inspected;
  inspected.is_scene_file = lower_extension(file) == ".toml";
  inspected.scene = load_scene(file, limits, inspected.warnings);
  throw_faults(inspected.scene, file);
  Warnings known;  // each asset's are among the scene's
  if (!inspected.is_scene_file) {
    inspected.assets.push_back(report_on(file, file, limits, known));
    return inspected;
  }
  for (const std::string& name : asset_names(inspected.scene)) {
    inspected.assets.push_back(report_on(name, Path(file).parent_path() / name, limits, known));
  }
  return inspected;
}

// "closed", as refraction needs it, or what of the object is not.
std::string closedness_words(const Object& object, const std::vector<char>& closed) {
  std::set<int> all, open;
  for (const PlacedMesh& part : object.parts) {
    all.insert(part.mesh);
    if (closed[static_cast<std::size_t>(part.mesh)] == 0) open.insert(part.mesh);
  }
  if (open.empty()) return "closed";
  if (open.size() == all.size()) return "open";
  return fmt::format("{} of {} meshes open", open.size(), all.size());
}

void print(const std::string& line) {
  fmt::print("{}\n", on_one_line(line));
}

void print_frame(const Scene& scene, const RestFrame& frame, const std::vector<char>& closed,
                 std::size_t number) {
  const Velocity& velocity = frame.coordinates().from_world.velocity();
  fmt::print("rest frame {}: velocity {} c, gamma {:.6g}\n", number, text_of(velocity.beta()),
             velocity.gamma());
  for (const int index : objects_of(frame)) {
    const Object& object = scene.objects[static_cast<std::size_t>(index)];
    const Bounds bounds = object_bounds(scene, object);
    print(fmt::format("  {}: {}, {}, {}, {} to {}, size {}, placed at {}", object.name,
                      count_of(object.parts.size(), "mesh placed", "meshes placed"),
                      count_of(triangles_of(scene, object), "triangle", "triangles"),
                      closedness_words(object, closed), text_of(bounds.lower),
                      text_of(bounds.upper), text_of(bounds.extent()),
                      text_of(object.worldline.reference.x * scene.light_speed)));
  }
}

void print_lights_and_materials(const Scene& scene) {
  for (const Light& light : scene.lights) {
    const Worldline& worldline = light.worldline;
    print(fmt::format("light {}: {}, {}, velocity {} c, placed at {}", light.name,
                      kind_name(light.kind), shine_text(light), text_of(worldline.velocity.beta()),
                      text_of(worldline.reference.x * scene.light_speed)));
  }
  for (const Material& material : scene.materials) {
    print(fmt::format("material {}: {}", material.name, text_of(material)));
  }
}

void print_scene(const std::string& file, const Scene& scene, const FrameSet& frames) {
  std::size_t stored = 0;
  for (const Mesh& mesh : scene.meshes) stored += mesh.triangles.size();
  fmt::print("{}: {}, {}, {}, {} stored, {}\n", file,
             count_of(frames.frames().size(), "rest frame", "rest frames"),
             count_of(scene.objects.size(), "object", "objects"),
             count_of(scene.materials.size(), "material", "materials"),
             count_of(stored, "triangle", "triangles"),
             count_of(scene.images.size(), "image", "images"));
  const std::vector<char> closed = closedness_of(scene.meshes);
  std::size_t number = 0;
  for (const RestFrame& frame : frames.frames()) print_frame(scene, frame, closed, ++number);
  print_lights_and_materials(scene);
}

bool moves(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.worldline.velocity.gamma() > 1; });
}

void print_text(const std::string& file, const Inspected& inspected, const FrameSet& frames) {
  const Scene& scene = inspected.scene;
  const bool says_more = inspected.is_scene_file || moves(scene);
  if (inspected.is_scene_file) print_scene(file, scene, frames);
  for (const AssetReport& report : inspected.assets) fmt::print("{}", text_of(report));
  if (says_more && !inspected.is_scene_file) print_scene("as a scene", scene, frames);
  fmt::print("memory: meshes {}, images {}, Embree {} ({} to build); rendering takes up to {}\n",
             size_text(static_cast<double>(bytes_in_memory(scene.meshes))),
             size_text(static_cast<double>(bytes_in_memory(scene.images) +
                                           bytes_in_memory(scene.sky_maps))),
             size_text(static_cast<double>(frames.embree_bytes())),
             size_text(static_cast<double>(frames.peak_embree_bytes())),
             size_text(static_cast<double>(needs_of(scene, frames).bytes)));
  if (!inspected.warnings.empty()) fmt::print("warnings:\n");
  for (const std::string& warning : inspected.warnings) print("  " + warning);
}

void print_json(const std::string& file, const Inspected& inspected, const FrameSet& frames) {
  const Scene& scene = inspected.scene;
  nlohmann::ordered_json assets = nlohmann::ordered_json::array();
  for (const AssetReport& report : inspected.assets) assets.push_back(json_of(report));
  const nlohmann::ordered_json document = {
      {"file", file},
      {"scene", json_of(scene, frames, closedness_of(scene.meshes))},
      {"assets", assets},
      {"warnings", inspected.warnings}};
  fmt::print("{}\n", document_text(document));
}

}  // namespace

std::vector<int> objects_of(const RestFrame& frame) {
  std::vector<int> objects;
  for (const FramePart& part : frame.parts()) {
    if (objects.empty() || part.object != objects.back()) objects.push_back(part.object);
  }
  return objects;
}

std::size_t triangles_of(const Scene& scene, const Object& object) {
  std::size_t count = 0;
  for (const PlacedMesh& part : object.parts) {
    count += scene.meshes[static_cast<std::size_t>(part.mesh)].triangles.size();
  }
  return count;
}

Bounds object_bounds(const Scene& scene, const Object& object) {
  Bounds bounds = bounds_of_placed(scene.meshes, object.parts);
  bounds.lower *= scene.light_speed;
  bounds.upper *= scene.light_speed;
  return bounds;
}

bool is_closed(const Object& object, const std::vector<char>& closed) {
  return std::all_of(object.parts.begin(), object.parts.end(), [&](const PlacedMesh& part) {
    return closed[static_cast<std::size_t>(part.mesh)] != 0;
  });
}

int info(const InfoOptions& options, const ImportLimits& limits) {
  const Inspected inspected = inspect(options.file, limits);
  const FrameSet frames(inspected.scene, thread_count());
  if (options.json) {
    print_json(options.file, inspected, frames);
  } else {
    print_text(options.file, inspected, frames);
  }
  return 0;
}

}  // namespace restframe

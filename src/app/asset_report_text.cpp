#include <fmt/format.h>

#include <iterator>
#include <set>

#include "app/asset_report.h"
#include "app/info_words.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t most_lines = 40;  // of one list

// A text that grows by lines; names in them are the file's, so control characters are replaced.
class Page {
 public:
  void line(int indent, const std::string& words) {
    text_.append(static_cast<std::size_t>(2 * indent), ' ').append(on_one_line(words)).append("\n");
  }

  // A heading and a line for each of `count` things, unless there are none.
  template <class Body>
  void list(const char* heading, std::size_t count, const Body& words_of) {
    if (count == 0) return;
    line(0, std::string(heading) + ":");
    for (std::size_t i = 0; i < std::min(count, most_lines); ++i) line(1, words_of(i));
    if (count > most_lines) line(1, fmt::format("... and {} more", count - most_lines));
  }

  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

std::string name_or(const std::string& name, const char* what, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", what, index) : name;
}

std::string mesh_words(const AssetReport& report, const MeshUse& use) {
  const auto index = static_cast<std::size_t>(use.mesh);
  const Mesh& mesh = report.asset.meshes[index];
  const std::string instances = use.count > 1 ? fmt::format("{} instances of ", use.count) : "";
  return fmt::format("{}mesh {} ({})", instances, name_or(mesh.name, "mesh", index),
                     count_of(mesh.triangles.size(), "triangle", "triangles"));
}

std::string node_words(const AssetReport& report, const FoldedNode& folded) {
  const AssetTree& tree = report.asset.tree;
  const AssetNode& node = tree.nodes[static_cast<std::size_t>(folded.node)];
  std::vector<std::string> has;
  for (const MeshUse& use : mesh_uses(report.asset, folded.node)) {
    has.push_back(mesh_words(report, use));
  }
  if (node.light >= 0) {
    const auto index = static_cast<std::size_t>(node.light);
    has.push_back("light " + name_or(tree.lights[index].name, "light", index));
  }
  if (node.camera >= 0) {
    const auto index = static_cast<std::size_t>(node.camera);
    has.push_back("camera " + name_or(tree.cameras[index].name, "camera", index));
  }
  if (has_extras(tree, ExtrasOf::node, folded.node)) has.emplace_back("extras.restframe");
  const std::string times = folded.count > 1 ? fmt::format(" x {}", folded.count) : "";
  return fmt::format("{}{}{}{}", folded.name, times, has.empty() ? "" : ": ", fmt::join(has, ", "));
}

void add_nodes(const AssetReport& report, const FoldedNode& parent, int indent, Page& page) {
  for (const FoldedNode& child : parent.children) {
    page.line(indent, node_words(report, child));
    add_nodes(report, child, indent + 1, page);
  }
  if (parent.more > 0) {
    page.line(indent, fmt::format("... and {}", count_of(parent.more, "more node", "more nodes")));
  }
}

void add_head(const AssetReport& report, Page& page) {
  const Asset& asset = report.asset;
  std::size_t stored = 0;
  for (const Mesh& mesh : asset.meshes) stored += mesh.triangles.size();
  page.line(0,
            fmt::format("{}: {}", report.file, size_text(static_cast<double>(report.file_bytes))));
  page.line(1, fmt::format("{}, {} placed {}, {} ({} stored)",
                           count_of(report.node_count, "node", "nodes"),
                           count_of(asset.meshes.size(), "mesh", "meshes"),
                           count_of(report.placed_count, "time", "times"),
                           count_of(report.triangle_count, "triangle", "triangles"), stored));
  page.line(1,
            fmt::format("{}, {}, {}, {}", count_of(asset.materials.size(), "material", "materials"),
                        count_of(asset.images.size(), "texture", "textures"),
                        count_of(asset.tree.lights.size(), "light", "lights"),
                        count_of(asset.tree.cameras.size(), "camera", "cameras")));
  if (!report.bounds.empty()) {
    page.line(1, fmt::format("from {} to {}, size {}", text_of(report.bounds.lower),
                             text_of(report.bounds.upper), text_of(report.bounds.extent())));
  }
  if (!asset.extensions.empty()) {
    page.line(1, fmt::format("extensions: {}", fmt::join(asset.extensions, ", ")));
  }
}

std::string scene_words(const AssetTree& tree, std::size_t index) {
  const auto i = static_cast<int>(index);
  std::size_t nodes = 0;
  for (const NodeRange& range : nodes_of_scene(tree, i)) {
    nodes += static_cast<std::size_t>(range.end - range.begin);
  }
  return fmt::format("{}: {}{}{}", name_or(tree.scenes[index].name, "scene", index),
                     count_of(nodes, "node", "nodes"), i == tree.default_scene ? ", shown" : "",
                     has_extras(tree, ExtrasOf::scene, i) ? ", extras.restframe" : "");
}

std::string mesh_line(const AssetReport& report, std::size_t index) {
  const Mesh& mesh = report.asset.meshes[index];
  std::set<int> slots;
  std::vector<std::string> materials;
  for (const MaterialRange& range : mesh.materials) {
    if (!slots.insert(range.slot).second) continue;
    materials.push_back(report.asset.materials[static_cast<std::size_t>(range.slot)].name);
  }
  const std::size_t placed = report.placed[index];
  return fmt::format("{}: {}, {}, {}, {}{}, of {}", name_or(mesh.name, "mesh", index),
                     count_of(mesh.triangles.size(), "triangle", "triangles"),
                     count_of(mesh.positions.size(), "vertex", "vertices"),
                     report.closed[index] != 0 ? "closed" : "open",
                     size_text(static_cast<double>(bytes_in_memory(mesh))),
                     placed == 1 ? "" : fmt::format(", placed {} times", placed),
                     fmt::join(materials, ", "));
}

std::string image_line(const Image& image, std::size_t index) {
  return fmt::format("{}: {} x {} pixels, {}{}", name_or(image.name, "image", index), image.width,
                     image.height, image.format.empty() ? "" : image.format + ", ",
                     size_text(static_cast<double>(image.rgba.size())));
}

std::string camera_line(const AssetTree& tree, std::size_t index) {
  const AssetCamera& camera = tree.cameras[index];
  return fmt::format("{}: {}", name_or(camera.name, "camera", index),
                     camera.is_perspective ? fmt::format("field of view {:.4g} degrees",
                                                         glm::degrees(camera.vertical_fov))
                                           : "orthographic, not supported");
}

std::string light_line(const AssetTree& tree, std::size_t index) {
  const Light& light = tree.lights[index];
  const std::string cone =
      light.kind == LightKind::spot
          ? fmt::format(", cone {:.4g} to {:.4g} degrees", glm::degrees(light.inner_cone),
                        glm::degrees(light.outer_cone))
          : "";
  return fmt::format("{}: {}, {}{}", name_or(light.name, "light", index), kind_name(light.kind),
                     shine_text(light), cone);
}

}  // namespace

std::string text_of(const AssetReport& report) {
  const Asset& asset = report.asset;
  const AssetTree& tree = asset.tree;
  const auto extras = [&](ExtrasOf of, std::size_t index) {
    return has_extras(tree, of, static_cast<int>(index)) ? ", extras.restframe" : "";
  };
  Page page;
  add_head(report, page);
  if (tree.scenes.size() > 1) {
    page.list("scenes", tree.scenes.size(), [&](std::size_t i) { return scene_words(tree, i); });
  }
  if (!report.nodes.children.empty()) page.line(0, "nodes:");
  add_nodes(report, report.nodes, 1, page);
  page.list("meshes", asset.meshes.size(), [&](std::size_t i) { return mesh_line(report, i); });
  page.list("materials", asset.materials.size(), [&](std::size_t i) {
    return asset.materials[i].name + ": " + text_of(asset.materials[i]) +
           extras(ExtrasOf::material, i);
  });
  page.list("textures", asset.images.size(),
            [&](std::size_t i) { return image_line(asset.images[i], i); });
  page.list("lights", tree.lights.size(),
            [&](std::size_t i) { return light_line(tree, i) + extras(ExtrasOf::light, i); });
  page.list("cameras", tree.cameras.size(),
            [&](std::size_t i) { return camera_line(tree, i) + extras(ExtrasOf::camera, i); });
  return std::move(page).text();
}

}  // namespace restframe

// Nodes and scenes: transforms that are ones, and a graph that is a forest.

#include <algorithm>
#include <cmath>

#include "importers/gltf_check.h"
#include "importers/gltf_layout.h"

namespace restframe {
namespace {

constexpr double most = 1e300;           // of any number: below infinity
constexpr std::size_t deepest = 10'000;  // levels of nodes

void check_matrix(const Place& node) {
  node.check_numbers("matrix", 16, -most, most);
  const Place matrix = node.member("matrix");
  for (std::size_t column = 0; column < 4; ++column) {
    const Place last = matrix.element(4 * column + 3);
    const double expected = column == 3 ? 1 : 0;
    if (std::abs(last.value().get<double>() - expected) > 1e-5) {
      last.fault("is " + last.value().dump() + ", but the last row must be 0 0 0 1");
    }
  }
  for (const char* key : {"translation", "rotation", "scale"}) {
    if (node.has(key)) node.fault(std::string("has both a matrix and a ") + key);
  }
}

void check_transform(const Place& node) {
  if (node.has("matrix")) {
    check_matrix(node);
    return;
  }
  node.check_numbers("translation", 3, -most, most);
  node.check_numbers("scale", 3, -most, most);
  node.check_numbers("rotation", 4, -2, 2);
  if (!node.has("rotation")) return;
  double squared_length = 0;
  for (const Json& component : node.value()["rotation"]) {
    squared_length += component.get<double>() * component.get<double>();
  }
  if (std::abs(squared_length - 1) > 0.02) {
    node.member("rotation")
        .fault("is a quaternion of length " + Json(std::sqrt(squared_length)).dump() +
               ", must be 1");
  }
}

void check_instance_attribute(const Place& attributes, const char* key, const char* type,
                              const Place& document) {
  if (!attributes.has(key)) return;
  const Place attribute = attributes.member(key);
  const Json& accessor = accessor_at(document, attribute.value().get<std::int64_t>());
  const auto component = accessor["componentType"].get<std::uint64_t>();
  const bool quantized = (component == component_i8 || component == component_i16) &&
                         accessor.value("normalized", false) && std::string(key) == "ROTATION";
  if (accessor["type"] != type || !(component == component_f32 || quantized)) {
    attribute.fault(std::string("must be ") + type + " of floats");
  }
}

// The number of instances; 1 where the node is not instanced.
std::uint64_t check_instances(const Place& node, const Place& document) {
  if (!node.has("extensions")) return 1;
  const Place extensions = node.member("extensions");
  if (!extensions.has("EXT_mesh_gpu_instancing")) return 1;
  const Place instancing = extensions.member("EXT_mesh_gpu_instancing");
  instancing.require_object();
  instancing.require_member("attributes");
  const Place attributes = instancing.member("attributes");
  attributes.require_object();
  if (attributes.size() == 0) attributes.fault("is empty");
  std::uint64_t instances = 0;
  for (const auto& [name, value] : attributes.value().items()) {
    const std::int64_t index = attributes.index(name.c_str(), count_of(document, "accessors"));
    const auto count = accessor_at(document, index)["count"].get<std::uint64_t>();
    if (instances != 0 && count != instances) {
      attributes.member(name.c_str())
          .fault("has " + std::to_string(count) + " elements, another " +
                 std::to_string(instances));
    }
    instances = count;
  }
  check_instance_attribute(attributes, "TRANSLATION", "VEC3", document);
  check_instance_attribute(attributes, "ROTATION", "VEC4", document);
  check_instance_attribute(attributes, "SCALE", "VEC3", document);
  return instances;
}

using Parents = std::vector<std::int64_t>;  // -1: none

void check_children(const Place& node, std::size_t index, Parents& parents) {
  if (!node.has("children")) return;
  const Place children = node.member("children");
  children.require_array();
  for (std::size_t i = 0; i < children.size(); ++i) {
    const Place place = children.element(i);
    const auto child = static_cast<std::size_t>(place.as_integer(0, parents.size() - 1));
    if (parents[child] >= 0) {
      place.fault("node " + std::to_string(child) + " has another parent, node " +
                  std::to_string(parents[child]));
    }
    parents[child] = static_cast<std::int64_t>(index);
  }
}

// With one parent each, a node is in a cycle or below one if walking upwards does not end. Depths
// that are known already end the walk, so that all walks together are linear.
void check_forest(const Place& nodes, const Parents& parents) {
  std::vector<std::size_t> depth(parents.size(), 0);  // 0: not known yet
  std::vector<std::size_t> walk;
  for (std::size_t start = 0; start < parents.size(); ++start) {
    walk.clear();
    std::size_t node = start;
    while (depth[node] == 0) {
      walk.push_back(node);
      if (parents[node] < 0) break;
      node = static_cast<std::size_t>(parents[node]);
      if (walk.size() > parents.size()) nodes.element(node).fault("is its own descendant: a cycle");
    }
    std::size_t level = depth[node];
    for (auto each = walk.rbegin(); each != walk.rend(); ++each) {
      depth[*each] = ++level;
      if (level > deepest) {
        nodes.element(*each).fault("is more than " + std::to_string(deepest) + " levels deep");
      }
    }
  }
}

void check_scenes(const Place& document, const Parents& parents) {
  document.index("scene", count_of(document, "scenes"));
  for_each_object(document, "scenes", [&](const Place& scene) {
    if (!scene.has("nodes")) return;
    const Place roots = scene.member("nodes");
    roots.require_array();
    std::vector<bool> listed(parents.size(), false);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const Place place = roots.element(i);
      if (parents.empty()) place.fault("there are no nodes");
      const auto root = static_cast<std::size_t>(place.as_integer(0, parents.size() - 1));
      if (parents[root] >= 0) {
        place.fault("node " + std::to_string(root) + " is not a root: node " +
                    std::to_string(parents[root]) + " is its parent");
      }
      if (listed[root]) place.fault("node " + std::to_string(root) + " is listed twice");
      listed[root] = true;
    }
  });
}

void check_node(const Place& node, const Place& document) {
  node.index("mesh", count_of(document, "meshes"));
  node.index("skin", count_of(document, "skins"));
  node.index("camera", count_of(document, "cameras"));
  check_transform(node);
}

}  // namespace

void check_nodes(const Place& document) {
  const std::size_t limit = document.context().limits.nodes;
  Parents parents(count_of(document, "nodes"), -1);
  if (parents.size() > limit) {
    document.member("nodes").fault("has " + std::to_string(parents.size()) +
                                   " nodes, the limit is " + std::to_string(limit) +
                                   "; --max-nodes raises it");
  }
  std::size_t index = 0;
  std::uint64_t instances = 0;
  for_each_object(document, "nodes", [&](const Place& node) {
    check_node(node, document);
    check_children(node, index++, parents);
    instances += check_instances(node, document);
    if (instances > limit) {
      node.fault("more than " + std::to_string(limit) +
                 " instances and nodes in all; --max-nodes raises the limit");
    }
  });
  if (!parents.empty()) {
    const Place nodes = document.member("nodes");
    check_forest(nodes, parents);
  }
  check_scenes(document, parents);
}

}  // namespace restframe

#pragma once

// What an asset's file says besides its triangles: nodes, and what stands at them.

#include <cstdint>
#include <string>
#include <vector>

#include "physics/vectors.h"
#include "scene/light.h"

namespace restframe {

struct AssetNode {
  std::string name;  // may be empty, and several may have the same
  int parent = -1;   // -1: a root
  int number = 0;    // where it stands in the file: glTF's index, a line of a text file; or 0
  int light = -1, camera = -1;  // what is at the node: indices into the tree's; -1: none
  Mat4 asset_from_node{1};      // affine; finite where a mesh, light, camera or extras need it
};

// One of several that a glTF file may hold.
struct AssetScene {
  std::string name;
  std::vector<int> roots;  // nodes; one may be in several scenes
};

// As the file defines it; any number of nodes may place it, looking along their -Z, their +Y up.
struct AssetCamera {
  std::string name;
  bool is_perspective = true;  // else it can not be used
  double vertical_fov = 1;     // radians
};

enum class ExtrasOf : std::uint8_t { scene, node, material, light, camera };

// glTF's `extras.restframe` of something: what its author says to restframe.
struct AssetExtras {
  ExtrasOf of = ExtrasOf::scene;
  int index = 0;  // into the tree's scenes, nodes, lights or cameras, or the asset's materials
  std::string
      text;  // JSON on one line: whatever stands there, such as an object, or a string of TOML
  std::string place;  // its JSON pointer: "/nodes/3/extras/restframe"
};

struct AssetTree {
  // Depth first: a node stands before its children, and a subtree in one piece.
  std::vector<AssetNode> nodes;
  // Empty where all nodes are the one scene. The indices of scenes, lights and cameras are the
  // file's.
  std::vector<AssetScene> scenes;
  int default_scene = 0;
  // As they shine at rest at the origin of a node's coordinates, along its -Z: kind, colour,
  // intensity (already W/sr or W/m^2) and cones.
  std::vector<Light> lights;
  std::vector<AssetCamera> cameras;
  std::vector<AssetExtras> extras;  // in the order of ExtrasOf, then of indices
  // What goes before a node's `number` in messages ("FILE:/nodes/3", "FILE:12").
  std::string number_prefix;
};

// "/nodes/3", or "12", a line; for messages "FILE:PLACE: ...".
std::string place_of(const AssetTree& tree, int node);

// Nodes from `begin` up to, not including, `end`.
struct NodeRange {
  int begin = 0, end = 0;

  bool operator==(const NodeRange&) const = default;
};
// Any set of nodes: in rising order, apart from each other, none empty.
using NodeRanges = std::vector<NodeRange>;

// The node and all that is below it.
NodeRange subtree(const AssetTree& tree, int node);

NodeRanges nodes_of_scene(const AssetTree& tree, int scene);
// The nodes that are shown where nobody chooses.
NodeRanges nodes_of_default_scene(const AssetTree& tree);

// Ranges in any order, which may overlap.
NodeRanges united(std::vector<NodeRange> ranges);
// Those of `nodes` that are not among the others; and those that are.
NodeRanges without(const NodeRanges& nodes, const NodeRanges& others);
NodeRanges common(const NodeRanges& nodes, const NodeRanges& others);

// What is at a node: where, in the asset's coordinates; which way (-Z) and what is up (+Y), unit
// lengths. Both are 0 where the transform squeezes them to nothing or along each other.
struct NodePose {
  Vec3 position{0}, forward{0}, up{0};
};
NodePose pose_of(const AssetNode& node);

}  // namespace restframe

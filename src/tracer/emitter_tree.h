#pragma once

#include <cstdint>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// One emitting triangle, at rest.
struct TreeLeaf {
  Vec3 lower{0}, upper{0};  // its bounds
  Vec3 normal{0};           // of its front, unit
  bool two_sided = false;
  double power = 0;
  std::uint32_t index = 0;  // what the tree calls it
};

// What is to be lit, in the emitters' rest frame.
struct Receiver {
  Vec3 place{0};
  Vec3f facing{
      0};  // light comes from the half space around this, a unit vector; 0: from all around
};

// A hierarchy of lights in one rest frame (after Conty Estevez and Kulla 2018): emitters are chosen by
// their power over the squared distance and by whether they and the receiver face each other, by walking
// down from the root and choosing between two nodes at each step.
class EmitterTree {
 public:
  EmitterTree() = default;
  explicit EmitterTree(std::vector<TreeLeaf> leaves);

  bool empty() const { return leaf_of_place_.empty(); }

  struct Chosen {
    std::uint32_t leaf = 0;
    double chance = 0;  // 0: nothing faces the receiver
  };
  Chosen choose(const Receiver& receiver, double u) const;

  // Of choose() to take that leaf.
  double chance(const Receiver& receiver, std::uint32_t leaf) const;

 private:
  struct Node {
    Vec3f center{0};    // relative to the tree's
    float radius = 0;   // of a sphere around all below
    Vec3f axis{0};      // around which all normals below lie ...
    float spread = -1;  // ... within the angle of this cosine; -1: they are everywhere
    float power = 0;
  };
  void build(std::vector<TreeLeaf>& leaves, std::size_t begin, std::size_t end);
  Node node_of(const TreeLeaf* begin, const TreeLeaf* end) const;
  // A receiver relative to the tree's center.
  struct Local {
    Vec3f place, facing;
    bool faces = false;
  };
  Local localised(const Receiver& receiver) const;
  static float importance(const Node& node, const Local& receiver);
  // Of taking the first child of a node, of which the first `left` leaves are below that.
  double first_chance(std::size_t node, std::size_t left, const Local& receiver) const;

  Vec3 center_{0};
  // A node, then all below its first child, then all below its second: one of n leaves has 2 n - 1.
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_place_, place_of_leaf_;
};

}  // namespace restframe

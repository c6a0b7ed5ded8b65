#pragma once

// An asset's nodes as people like to read them: siblings that are alike become one line, and a huge
// tree a page.

#include <cstddef>
#include <string>
#include <vector>

#include "scene/asset.h"

namespace restframe {

// Alike siblings: names that differ in their last digits at most, with equal meshes, lights and
// cameras, and alike below.
struct FoldedNode {
  int node = -1;          // the first of them; -1: the list of the roots
  std::string name;       // or what they have in common, and a star: "tram_*"
  std::size_t count = 1;  // of them
  std::vector<FoldedNode> children;
  std::size_t more = 0;  // nodes below the first of them that are not listed: they are too many
};

struct FoldingLimits {
  int depth = 12;             // levels that are listed
  std::size_t siblings = 25;  // of one node
  std::size_t lines = 300;    // in all
};

// The nodes below one that is none itself.
FoldedNode folded_nodes(const Asset& asset, const NodeRanges& nodes,
                        const FoldingLimits& limits = {});

// "tram", or "node 3" by its number in the file where it has no name.
std::string shown_name(const AssetTree& tree, int node);

// How often the node itself places each mesh.
struct MeshUse {
  int mesh = 0;
  std::size_t count = 0;
};
std::vector<MeshUse> mesh_uses(const Asset& asset, int node);

bool has_extras(const AssetTree& tree, ExtrasOf of, int index);

}  // namespace restframe

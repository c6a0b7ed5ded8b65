#pragma once

#include <utility>
#include <vector>

#include "scene/mesh.h"

namespace restframe {

// Where a triangle goes, and with which material slot.
struct TriangleTag {
  int group, slot;
};

// A mesh whose `materials` are yet to be made from its tags, one a triangle.
struct TaggedMesh {
  Mesh mesh;
  std::vector<TriangleTag> tags;
};

// One mesh for each group that occurs, groups in increasing order, triangles in their old order,
// with material ranges.
std::vector<std::pair<int, Mesh>> split_by_group(TaggedMesh whole);

}  // namespace restframe

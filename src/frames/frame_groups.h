#pragma once

#include <span>
#include <vector>

#include "frames/traversable_mesh.h"
#include "scene/scene.h"

namespace restframe {

// Which objects (indices into scene.objects) share a RestFrame: those of exactly equal velocity, as
// far as single precision, in which Embree works, spans both the smallest of them and all together.
// Objects without parts are in none. meshes: one a mesh of the scene.
std::vector<std::vector<int>> frame_groups(const Scene& scene,
                                           std::span<const TraversableMesh> meshes);

}  // namespace restframe

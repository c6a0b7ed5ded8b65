#pragma once

// What the text and the JSON of `restframe info` say of a scene alike.

#include <vector>

#include "frames/frame_set.h"

namespace restframe {

std::vector<int> objects_of(const RestFrame& frame);
std::size_t triangles_of(const Scene& scene, const Object& object);

// Of everything in the object, in scene units around its origin.
Bounds object_bounds(const Scene& scene, const Object& object);

// Whether all its meshes are, as refraction needs it; `closed`: of each mesh.
bool is_closed(const Object& object, const std::vector<char>& closed);

}  // namespace restframe

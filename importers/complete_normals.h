#pragma once

#include <cstddef>

#include "scene/mesh.h"

namespace restframe {

// Brings the normals that a file gave to unit length. Those without a direction (zero, NaN) are
// computed by crease angle, as all are where there are none (add_normals). Returns how many of the
// given ones were without.
std::size_t complete_normals(Mesh& mesh);

}  // namespace restframe

#pragma once

#include "scene/asset.h"

namespace restframe::fuzz {

// Throws std::logic_error if something that the renderer relies on does not hold: indices in range,
// attributes one a vertex, finite positions, whole images.
void require_sound(const Asset& asset);

}  // namespace restframe::fuzz

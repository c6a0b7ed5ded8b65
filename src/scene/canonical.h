#pragma once

#include <string>

#include "scene/scene.h"

namespace restframe {

// Everything that decides a scene's pixels, one `key = value` a line, numbers with all their
// digits. Two scenes with equal text and equal source files give equal pictures. Without output
// paths, threads, and the choice of pictures.
std::string canonical_settings(const Scene& scene);

}  // namespace restframe

#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

// The parts of validate() that concern what objects are made of. Each appends faults in words.
void validate_mesh(const Mesh& mesh, std::vector<std::string>& faults);
void validate_materials(const Scene& scene, std::vector<std::string>& faults);
void validate_textures(const Scene& scene, std::vector<std::string>& faults);

}  // namespace restframe

#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

// Parts of validate(). Each appends faults in words.
void validate_exposure(const ExposureSettings& exposure, std::vector<std::string>& faults);
void validate_lens(const Camera& camera, std::vector<std::string>& faults);

// Those that concern what objects are made of.
void validate_mesh(const Mesh& mesh, std::vector<std::string>& faults);
void validate_materials(const Scene& scene, std::vector<std::string>& faults);
void validate_textures(const Scene& scene, std::vector<std::string>& faults);

}  // namespace restframe

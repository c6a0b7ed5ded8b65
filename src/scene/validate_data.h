#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

// Light-seconds and seconds beyond which squares and products could overflow.
constexpr double farthest = 1e100;

// The parts of validate(). Each appends faults in words.

// name: of what moves so, for messages.
void validate_worldline(const Worldline& worldline, const std::string& name,
                        std::vector<std::string>& faults);
void validate_camera(const Camera& camera, std::vector<std::string>& faults);
// The camera at the time of each picture: for scenes without other faults.
void validate_poses(const Scene& scene, std::vector<std::string>& faults);
void validate_mesh(const Mesh& mesh, std::vector<std::string>& faults);
void validate_materials(const Scene& scene, std::vector<std::string>& faults);
void validate_textures(const Scene& scene, std::vector<std::string>& faults);

}  // namespace restframe

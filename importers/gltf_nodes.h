#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"

namespace restframe {

// The meshes as the default scene places them (scene 0 if none is the default, all root nodes if
// there is no scene). Parts name the model's meshes.
std::vector<Part> place_meshes(const GltfContext& context, const tinygltf::Model& model);

}  // namespace restframe

#pragma once

#include <tiny_gltf.h>

#include <vector>

#include "importers/gltf_context.h"
#include "physics/vectors.h"

namespace restframe {

// What of an accessor to read.
struct Wanted {
  const std::vector<std::uint32_t>* elements = nullptr;  // increasing; null: all
  std::size_t room = 0;  // for how many there is to be memory, if that is more than are read
};

// The elements of an accessor of a checked document, normalized integers as the numbers they stand
// for. Throws where sparse indices are out of range or order. An accessor of another number of
// components gives the components that both have, and 1 for the others.
std::vector<Vec2f> read_vec2(const GltfContext& context, const tinygltf::Model& model, int accessor,
                             const Wanted& wanted = {});
std::vector<Vec3f> read_vec3(const GltfContext& context, const tinygltf::Model& model, int accessor,
                             const Wanted& wanted = {});
std::vector<Vec4f> read_vec4(const GltfContext& context, const tinygltf::Model& model, int accessor,
                             const Wanted& wanted = {});
// MAT4 of floats only.
std::vector<Mat4> read_mat4(const GltfContext& context, const tinygltf::Model& model, int accessor);

// Writes as many integers as the accessor has elements.
void read_indices(const GltfContext& context, const tinygltf::Model& model, int accessor,
                  std::uint32_t* indices);

// How many different integers below `end` there are among the accessor's; takes next to no memory.
std::size_t count_indices(const GltfContext& context, const tinygltf::Model& model, int accessor,
                          std::size_t end);

}  // namespace restframe

#pragma once

// Words and numbers that `restframe info` has for scenes and assets alike.

#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

std::string text_of(const Vec3& v);
std::string count_of(std::size_t count, const char* one, const char* many);
std::string size_text(double bytes);  // "3.4 kB"

// "[1, 1, 1], textured, transparent": what a look at the material tells.
std::string text_of(const Material& material);

// "spot", and so on.
const char* kind_name(LightKind kind);
// "color [1, 1, 1], 2.5 W/sr"
std::string shine_text(const Light& light);

std::size_t bytes_in_memory(const Mesh& mesh);
std::size_t bytes_in_memory(const std::vector<Mesh>& meshes);
std::size_t bytes_in_memory(const std::vector<Image>& images);
std::size_t bytes_in_memory(const std::vector<SkyMap>& maps);

// Of each mesh, whether it is closed. Bytes, since vector<bool> is none of its type.
std::vector<char> closedness_of(const std::vector<Mesh>& meshes);

// Exact, or of the boxes around the meshes where their vertices are too many to look at.
Bounds bounds_of_placed(const std::vector<Mesh>& meshes, const std::vector<PlacedMesh>& parts);

}  // namespace restframe

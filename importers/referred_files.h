#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace restframe {

// The files that an asset is made of besides itself, relative to its folder: buffers and images of
// a .gltf, material libraries of an .obj and their textures. Only those that exist as regular
// files; for hashes, after the asset's importer has checked it.
std::vector<std::string> referred_files(const std::filesystem::path& asset);

}  // namespace restframe

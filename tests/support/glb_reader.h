#pragma once

// Reads back binary glTF as a test needs it, independently of the importers: tightly packed
// accessors of float vectors and 32-bit indices. Throws std::runtime_error on a container that
// breaks the rules.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "physics/vectors.h"

namespace restframe {

struct GlbFile {
  nlohmann::json json;
  std::string binary;

  std::vector<Vec3f> vectors(std::size_t accessor) const;
  std::vector<std::uint32_t> indices(std::size_t accessor) const;
};

GlbFile read_glb(const std::filesystem::path& path);

}  // namespace restframe

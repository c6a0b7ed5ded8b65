#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace restframe::fuzz {

struct GlbParts {
  std::string json, bin;
};

// Nothing if the bytes do not begin as a GLB does, or its chunks are not JSON and perhaps BIN.
std::optional<GlbParts> split_glb(std::string_view bytes);

std::string join_glb(const GlbParts& parts);

}  // namespace restframe::fuzz

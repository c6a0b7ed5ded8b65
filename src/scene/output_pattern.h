#pragma once

#include <optional>
#include <string>

namespace restframe {

// Why OutputSettings::path can not name `pictures` pictures ("path ... must have one run of #"), or
// nothing.
std::optional<std::string> output_pattern_fault(const std::string& path, int pictures);

}  // namespace restframe

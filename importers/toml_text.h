#pragma once

#include <string>

#include "importers/config_value.h"

namespace restframe {

// Parses TOML. Throws InputError ("FILE:LINE:COLUMN: what") where it is none. `place`: that of all
// positions.
ConfigTable parse_toml(const std::string& text, const std::string& file, int place = 0);

}  // namespace restframe

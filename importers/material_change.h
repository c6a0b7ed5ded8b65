#pragma once

#include <string_view>

#include "importers/scene_file.h"

namespace restframe {

// Whether `name` matches `pattern`, in which * stands for any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

// Makes the change to the material. Opacity that is not 1 makes it blend, unless it is a mask.
void apply(const MaterialChange& change, Material& material);

}  // namespace restframe

#pragma once

#include <string_view>

#include "importers/scene_file.h"

namespace restframe {

// Whether `name` matches `pattern`, in which * stands for any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

// Gives the property what the file says of it, if it says something. What a function replaces stays
// as the value in its gaps.
void set(const std::optional<Property>& given, TemporalNumber& number);
void set(const std::optional<Property>& given, TemporalColor& color);

// Makes the change to the material. Opacity that is not 1 makes it blend, unless it is a mask.
void apply(const MaterialChange& change, Material& material);

}  // namespace restframe

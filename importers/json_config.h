#pragma once

// What the author of an asset says to restframe inside of it (glTF's `extras.restframe`), as a
// settings file would have it.

#include <optional>
#include <string>

#include "importers/config_value.h"
#include "importers/fault_list.h"

namespace restframe {

// Parses JSON. Every value's position is a place of its own: its JSON pointer below `place`, which
// the list gave out. Nothing, and faults, where the text is no JSON, has a key twice, is deeper than
// 32, or makes the list's places more than five million.
std::optional<ConfigValue> parse_json(const std::string& text, int place, FaultList& faults);

// Of a JSON object, itself; of a JSON string, the TOML in it, with lines and columns of the string.
// Nothing, and faults, where it is neither.
std::optional<ConfigTable> parse_json_or_toml(const std::string& text, int place,
                                              FaultList& faults);

}  // namespace restframe

#pragma once

// What objects and lights state alike: where, how fast, and what their clock shows.

#include <string>

#include "importers/scene_file.h"

namespace restframe {

// `position` (that one unless given; lengths of the table), `time`, `clock`, and `velocity` or
// `gamma` with the vector `heading`, the key of which way the motion goes.
ClockedWorldline read_clocked_worldline(TableReader& table, const std::string& heading,
                                        double light_speed, const Vec3& position = Vec3(0));

}  // namespace restframe

#pragma once

// What objects and lights state alike: where, how fast, and what their clock shows.

#include <string>

#include "importers/scene_file.h"

namespace restframe {

// A worldline with a clock, as Object and Light have it.
struct ClockedWorldline {
  Worldline worldline;
  double clock = 0;          // what the clock shows at the reference event ...
  bool frame_clock = false;  // ... or: the rest frame's own time
};

// `position`, `time`, `clock`, and `velocity` or `gamma` with the vector `heading`, the key of which
// way the motion goes.
ClockedWorldline read_clocked_worldline(TableReader& table, const std::string& heading,
                                        double light_speed);

}  // namespace restframe

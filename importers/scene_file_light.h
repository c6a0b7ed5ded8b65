#pragma once

// The parts of read_lights that lights of assets share.

#include "importers/scene_file.h"

namespace restframe {

// A light of an asset at its node: what holds where its table says nothing else.
struct LightStart {
  Light light;           // at rest on what carries it
  bool carried = false;  // by something that has a motion of its own
  Vec3 position{0};      // in the asset
  int object = 0;        // the one that the asset is placed as
  Mat4 object_from_asset{1};
};

// One light, of an asset or (null) of a [[light]].
void read_light(const ConfigTable& table, const LightStart* start, SceneFile& file);

// Where lights are given, at `at`, and nothing uses them.
void warn_of_unused_lights(TextPosition at, SceneFile& file);

}  // namespace restframe

#pragma once

#include "frames/packet.h"

namespace restframe {

// What 16 samples saw: linear Rec. 709 and coverage, premultiplied.
using RadianceLanes = Lanes<Vec4f>;

// D^4 of light whose emitter is seen with this D by the camera if the scene beams, else 1: the only
// radiometric factor of a path (design, section 2, point 4).
inline float emitter_factor(bool beaming, double doppler) {
  const double squared = doppler * doppler;
  return beaming ? static_cast<float>(squared * squared) : 1.0F;
}

// What data layers say of one sample (design, section 7). Lengths in light-seconds.
struct SurfaceData {
  bool hit = false;
  int object = 0, material = 0;
  double distance = 0;  // that the light travelled, in the camera's rest frame
  double time_proper = 0, time_world = 0;
  double doppler = 0;
  Vec3 position{0};  // rest frame, relative to the object's origin
  Vec3 normal{0};
  Vec2f uv{0};
  // As the camera sees it (apparent_surface.h), if anyone asks.
  double depth = 0;         // distance along the view
  Vec3 apparent_normal{0};  // in the camera's axes: right, up, backwards
  Vec2 motion{0};  // on the film until the next picture, if anyone asks: pixels, right and up
};
using SurfaceDataLanes = Lanes<SurfaceData>;

struct SampleParts;
class CoverCounts;

// What is wanted of 16 samples besides their light; null: not wanted.
struct SampleLayers {
  SurfaceDataLanes* data = nullptr;
  CoverCounts* covers = nullptr;  // to be added to
  SampleParts* parts = nullptr;
};

}  // namespace restframe

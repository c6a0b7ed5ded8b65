#pragma once

#include "frames/packet.h"

namespace restframe {

// The events at which 16 rays hit, and what a ray that leaves one needs to be clear of the surface.
struct HitEvents {
  EventLanes<in::World> event;
  Vec3fLanes facet;  // the triangle's own unit normal, rest-frame axes, towards the ray
  // How far an origin may lie off the surface: as Embree's floats have it (traversal lengths), and
  // by what doubles lose on the way to the world and back (light-seconds, rest frame).
  Lanes<double> float_noise, double_noise;
};

}  // namespace restframe

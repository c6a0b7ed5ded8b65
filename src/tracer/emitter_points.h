#pragma once

// Points on emitting surfaces, one a path, as lights of it.

#include "tracer/emitters.h"
#include "tracer/surface_material.h"

namespace restframe {

// Numbers in [0, 1) that choose a point: rest frame, triangle there and two on it.
struct PointNumbers {
  Lanes<float> frame;
  Lanes<double> triangle;
  Lanes<float> u, v;
};

struct EmitterPoints {
  Lanes<std::int32_t> active;
  // As much of a hit there as materials ask for: what was met, and where on it.
  HitPacket hits;
  SurfaceLanes surfaces;
  Vec3Lanes place, normal;  // the emitter's rest frame; the normal is the front's, unit
  Lanes<double> per_area;   // density, per square light-second
};

// What paths need to know of where points are chosen.
struct EmitterStage {
  const Scene& scene;
  const FrameSet& frames;
  const Emitters& emitters;
};

// For the active lanes of `lit`, to light what is at the events. facing: as Receiver has it, in the axes
// of the surfaces.
void choose_points(const EmitterStage& stage, const EventLanes<in::World>& event,
                   const LitLanes& lit, const Vec3fLanes& facing, const PointNumbers& numbers,
                   EmitterPoints& points);

// How surface events see their points.
struct PointsSeen {
  Lanes<double> rest_t;   // of the point's event, in the emitter's rest frame
  Lanes<double> doppler;  // D from the point to the camera
  Lanes<double> density;  // of the direction, per steradian, in the surface's rest frame
};

// Sets which way the light of the points comes, and from how far; not what comes. Nothing comes from
// points that are seen edge on. Whether they are seen from behind goes to points.surfaces.back.
void see_points(const EmitterStage& stage, const EventLanes<in::World>& event, const LitLanes& lit,
                EmitterPoints& points, PointsSeen& seen, IncidentLanes& incident);

}  // namespace restframe

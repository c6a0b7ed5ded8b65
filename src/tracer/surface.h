#pragma once

#include <array>

#include "frames/frame_set.h"
#include "scene/scene.h"

namespace restframe {

// Where an object's clock and origin are in its rest frame.
struct ObjectPlace {
  double clock_at_anchor = 0;  // seconds, added to rest-frame time
  Vec3 origin{0};              // rest frame, relative to its anchor
};
std::vector<ObjectPlace> object_places(const Scene& scene, const FrameSet& frames);

// What a ray meets: the inputs of shading, in the object's rest frame and at the object's own time.
struct Surface {
  int object = 0;
  int material = 0;
  double clock = 0;      // what the object's clock shows at the hit
  double doppler = 1;    // D of light emitted here
  Vec3 normal{0, 0, 1};  // shading normal, unit, rest frame, towards the ray
  float cosine = 1;      // between the ray and the shading normal, in the rest frame, >= 0
  bool back = false;     // met from behind
  std::array<Vec2f, 2> uv{};
  Vec4f color{1};  // of the vertices
};

Surface surface_at(const Scene& scene, const FrameSet& frames,
                   const std::vector<ObjectPlace>& places, const HitPacket& hits, int lane);

// Where the hit rests, relative to its object's origin; light-seconds, rest-frame axes.
Vec3 position_on_object(const FrameSet& frames, const std::vector<ObjectPlace>& places,
                        const HitPacket& hits, int lane);

}  // namespace restframe

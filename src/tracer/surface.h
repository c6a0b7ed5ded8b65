#pragma once

#include <array>

#include "frames/frame_set.h"
#include "scene/scene.h"

namespace restframe {

// What a ray meets: the inputs of shading, in the object's rest frame.
struct Surface {
  int object = 0;
  int material = 0;
  Vec3f normal{0, 0, 1};  // shading normal, unit, towards the ray
  float cosine = 1;       // between the ray and the shading normal, >= 0
  bool back = false;      // met from behind
  std::array<Vec2f, 2> uv{};
  Vec4f color{1};  // of the vertices
};

Surface surface_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits, int lane);

// Where an object's clock and origin are in its rest frame.
struct ObjectPlace {
  double clock_at_anchor = 0;  // seconds, added to rest-frame time
  Vec3 origin{0};              // rest frame, relative to its anchor
};
std::vector<ObjectPlace> object_places(const Scene& scene, const FrameSet& frames);

// What the object's own clock shows at a refined hit (paper, equation 4, plus the clock's offset).
inline double clock_at(const ObjectPlace& place, const HitPacket& hits, int lane) {
  return hits.rest_t[lane] + hits.s[lane] * hits.rest_k_t[lane] + place.clock_at_anchor;
}

// D of light emitted at the hit.
inline double doppler_at(const HitPacket& hits, int lane) {
  return -1.0 / hits.rest_k_t[lane];
}

// Where a refined hit rests, relative to its object's origin; light-seconds, rest-frame axes.
Vec3 position_on_object(const FrameSet& frames, const ObjectPlace& place, const HitPacket& hits,
                        int lane);

}  // namespace restframe

#pragma once

#include "frames/frame_set.h"
#include "scene/scene.h"
#include "tracer/cover_counts.h"

namespace restframe {

// What 16 rays meet: the inputs of shading, in each object's rest frame. Lanes without a hit mean nothing.
struct SurfaceLanes {
  Lanes<std::int32_t> object, material;
  Vec3fLanes normal;         // shading normal, unit, towards the ray
  Lanes<float> cosine;       // between the ray and the shading normal, >= 0
  Lanes<std::int32_t> back;  // 1: met from behind
  bool colored = false;      // else no vertex met has a colour, and `color` means nothing
  Lanes<Vec4f> color;        // of the vertices

  Vec4f color_at(int lane) const { return colored ? color[lane] : Vec4f(1); }
};

// For the active lanes that hit something.
void surfaces_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits,
                 const Lanes<std::int32_t>& active, SurfaceLanes& surfaces);

// One lane of what was met covers `weight` of its sample.
inline void count_cover(const FrameSet& frames, const HitPacket& hits, const SurfaceLanes& surfaces,
                        int lane, float weight, CoverCounts& covers) {
  const FramePart& part = frames.frame(hits.frame[lane]).part(hits.part[lane]);
  covers.add(lane, part.object, part.name, surfaces.material[lane], weight);
}

// Texture coordinates of a hit; 0 where the mesh has none.
Vec2f uv_at(const Scene& scene, const FrameSet& frames, const HitPacket& hits, int lane, int set);

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

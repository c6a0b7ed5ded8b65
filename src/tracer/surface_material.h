#pragma once

// What a material is at one hit: its functions at the hit's own time, its textures at its place.

#include "scene/temporal_evaluator.h"
#include "tracer/bsdf.h"
#include "tracer/random.h"
#include "tracer/sample.h"
#include "tracer/surface.h"
#include "tracer/surface_tables.h"

namespace restframe {

// One lane of what a packet met.
struct MetSurface {
  const Scene& scene;
  const FrameSet& frames;
  const SurfaceLanes& surfaces;
  const HitPacket& hits;
  int lane;
  const SurfaceTables* tables = nullptr;  // else textures are not filtered, and tilt no normals
  float width = 0;                        // of the ray's cone here (footprint.h), light-seconds

  const Material& material() const {
    return scene.materials[static_cast<std::size_t>(surfaces.material[lane])];
  }
  const FramePart& part() const { return frames.frame(hits.frame[lane]).part(hits.part[lane]); }
  const Mesh& mesh() const { return scene.meshes[static_cast<std::size_t>(part().mesh)]; }
};

// White where no texture is used. Filtered over what the ray stands for.
Vec4f texel(const MetSurface& met, const TextureUse& use);

// The fraction of light that the surface's substance stops, from whatever side.
float opacity(const MetSurface& met, float texture_alpha, double clock,
              TemporalEvaluator& evaluator);

// Likewise, but back faces let everything pass unless they are to be seen.
float coverage(const MetSurface& met, float texture_alpha, double clock,
               TemporalEvaluator& evaluator);

Vec3f base_color(const MetSurface& met, const Vec4f& texture, double clock,
                 TemporalEvaluator& evaluator);
Vec3f emission(const MetSurface& met, double clock, TemporalEvaluator& evaluator);

// The microfacets' roughness, what they are made of, and how a dielectric's reflect.
void set_finish(const MetSurface& met, double clock, TemporalEvaluator& evaluator, BsdfLanes& bsdf);

// What lies over the surface, and how it lets light through.
BsdfLayers layers(const MetSurface& met, double clock, TemporalEvaluator& evaluator);

// The fraction of the surface's own light that a clear coat lets out at this cosine to the triangle's
// normal. (Other normals would do, but whoever chooses points of what shines must use the same.)
float below_coat(const MetSurface& met, float cosine, double clock, TemporalEvaluator& evaluator);

// What data layers say of a refined hit on a ray of the camera.
SurfaceData surface_data(const MetSurface& met, const ObjectPlace& place, const RayPacket& rays);

}  // namespace restframe

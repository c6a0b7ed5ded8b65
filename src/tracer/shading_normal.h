#pragma once

// Normals that normal maps tilt. The map's vector is taken in the mesh's coordinates, between the
// tangent, the bitangent cross(normal, tangent) * sign and the normal, none of them of unit length
// after interpolation (as MikkTSpace wants it), and comes to the rest frame as normals do: as if
// the bumps were geometry, whichever way the mesh is placed, mirrored or stretched.

#include "tracer/surface_material.h"

namespace restframe {

// Whether tilted_normals has anything to do.
inline bool has_normal_map(const Material& m) {
  return m.normal_texture.texture >= 0;
}

// Gives the lane the shading normal and cosine that the material's normal texture makes at this
// clock time. Towards the ray: a normal that would look away is mirrored to the ray's side, so its
// cosine is that of both, without a sign. `surfaces` are those of `met`, the lane not yet tilted.
void tilt_normal(const MetSurface& met, double clock, TemporalEvaluator& evaluator,
                 SurfaceLanes& surfaces);

// The normal of the lane's clearcoat, likewise: the mesh's own, or as the clearcoat's own normal
// texture tilts that. May be asked before tilt_normal and after.
Vec3f clearcoat_normal(const MetSurface& met);

// A shading normal for what mirrors: where the mirror image of `view` would come from below the
// triangle, the nearest one, about, whose does not. Without it such places are black. All unit; view
// and normal on the side of the facet's normal, or nearly so.
Vec3f reflecting_normal(const Vec3f& view, const Vec3f& facet, const Vec3f& normal);

}  // namespace restframe

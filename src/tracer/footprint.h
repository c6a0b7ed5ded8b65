#pragma once

// How much of a texture a ray stands for.
//
// A ray is the axis of a thin cone, as wide at the camera as a pixel is seen. The cross-section of a
// thin cone of light is the same in every frame: over a ray of parameter s and local frequency omega,
// the rest frame has the angle as D = 1/omega times the camera's, since solid angles go with D^2, and
// the distance as omega s. So the width is the camera's angle times s, and grows with s alone.

#include "scene/texture_filter.h"
#include "tracer/surface_material.h"

namespace restframe {

// The cone around a ray, light-seconds: width + slope * s. Where that is 0, textures are taken as they
// are at a point. Without initial values: packets of it are made even where nobody asks for them.
struct RayCone {
  float width, slope;

  float at(double s) const { return width + slope * static_cast<float>(s); }
};

// What the cone of a hit covers of a texture: the circle of met.width across the ray, thrown along
// it onto the triangle.
TextureFootprint footprint(const MetSurface& met, const TextureUse& use);

}  // namespace restframe

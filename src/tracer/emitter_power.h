#pragma once

// How much surfaces emit, over all times and places, for choosing among them.

#include <vector>

#include "scene/scene.h"
#include "scene/temporal_evaluator.h"

namespace restframe {

// Whether it can shine at any time.
bool emits(const Material& material);

// What a material's area emits per unit of area, but for textures. Never 0 where it can shine.
struct EmittedPower {
  double emission = 0;  // with the emission's texture
  double base = 0;      // with that of the base colour: of what is unlit
};
EmittedPower emitted_power(const Scene& scene, const Material& material,
                           TemporalEvaluator& evaluator);

// For each of `count` triangles from `first` on: its area, in the mesh's units, times what it emits
// on average. Where something can shine at all, no triangle that can gets 0.
std::vector<double> triangle_powers(const Scene& scene, const Mesh& mesh, std::uint32_t first,
                                    std::uint32_t count, const Material& material,
                                    const EmittedPower& power);

}  // namespace restframe

#pragma once

#include <string>

#include "support/scene_reading.h"

namespace restframe {

inline const std::string sphere_text = "[[object]]\nname = \"ball\"\nsphere = {fineness = 1}\n";
inline const std::string lattice_text =
    "[[object]]\nname = \"lattice\"\n"
    "lattice = {cells = [2, 2, 2], pitch = 1, ball = 0.15, rod = 0.05, fineness = 0}\n";
// The slots of the lattice.
inline constexpr std::size_t balls = 0, rods = 1;

// The material in a slot of the object's asset.
inline const Material& slot(const Scene& scene, std::size_t object, std::size_t index) {
  return scene.materials.at(static_cast<std::size_t>(scene.objects.at(object).materials.at(index)));
}

}  // namespace restframe

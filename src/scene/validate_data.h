#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace restframe {

// Light-seconds and seconds beyond which squares and products could overflow.
constexpr double farthest = 1e100;

// The numbers that a property allows.
struct Allowed {
  float low = 0, high = std::numeric_limits<float>::max();
};

// Constants out of range, and functions that the scene does not have; `what` names the property.
void validate_number(const Scene& scene, const TemporalNumber& number, const std::string& what,
                     std::vector<std::string>& faults, const Allowed& allowed = {});
void validate_color(const Scene& scene, const TemporalColor& color, const std::string& what,
                    std::vector<std::string>& faults, const Allowed& allowed = {});

// Parts of validate(). Each appends faults in words.
void validate_exposure(const ExposureSettings& exposure, std::vector<std::string>& faults);
// `name` names what moves so.
void validate_worldline(const Worldline& worldline, const std::string& name,
                        std::vector<std::string>& faults);
void validate_camera(const Camera& camera, std::vector<std::string>& faults);
void validate_lens(const Camera& camera, std::vector<std::string>& faults);
// Layers that others exclude, and groups of lights.
void validate_layers(const Scene& scene, std::vector<std::string>& faults);
// The camera at the time of each picture: for scenes without other faults.
void validate_poses(const Scene& scene, std::vector<std::string>& faults);

// Those that concern what objects are made of, and what lights them.
void validate_mesh(const Mesh& mesh, std::vector<std::string>& faults);
void validate_materials(const Scene& scene, std::vector<std::string>& faults);
void validate_textures(const Scene& scene, std::vector<std::string>& faults);
// What lights and materials emit.
void validate_spectrum(const Scene& scene, const TemporalNumber& temperature,
                       const EmissionSpectrum& spectrum, const std::string& name,
                       std::vector<std::string>& faults);
void validate_sky_map(const SkyMap& map, std::vector<std::string>& faults);
// But for its worldline. `name` names it in faults.
void validate_light(const Scene& scene, const Light& light, const std::string& name,
                    std::vector<std::string>& faults);

}  // namespace restframe

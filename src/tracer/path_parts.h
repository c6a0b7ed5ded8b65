#pragma once

#include "physics/spectrum_table.h"
#include "tracer/sample_parts.h"

namespace restframe {

// What a surface sends on of light from one direction. Without initial values.
struct LobeSplit {
  Vec3f all, matte;  // colours: by all its lobes, and by the diffuse and sheen lobes
  Vec3f share;       // of the matte lobes, as the path's lanes have it
  double omega;      // the light's frequency there over that in the camera
  bool through;      // to beyond the surface
};

// Keeps account of the light of 16 paths as it arrives, if anyone asks: by the lobes of the first
// surface, and by groups of lights (as LightGroups tell them).
class PathParts {
 public:
  void begin(SampleParts* wanted, const LightGroups& groups) {
    sample_ = wanted;
    by_wavelength_ = false;
    if (wanted == nullptr) return;
    wanted->clear(groups);
    scatterings_.fill(0);
  }
  bool are_wanted() const { return sample_ != nullptr; }
  // The colours that the path's three lanes, three wavelengths, are shown as.
  void set_wavelengths(int lane, const glm::mat3& color_from_lanes) {
    color_from_lanes_[lane] = color_from_lanes;
    by_wavelength_ = true;
  }

  void set_albedo(int lane, const Vec3f& albedo) {
    sample_->at(SampleParts::albedo).set(lane, albedo);
  }

  // The path goes on from a surface; of the first, `split` says how.
  bool has_scattered(int lane) const { return scatterings_[lane] > 0; }
  void scatter(int lane, const LobeSplit& split) { first_[lane] = split, scatterings_[lane] = 1; }
  void scatter(int lane) { ++scatterings_[lane]; }

  // Light in the path's lanes: what the path meets at its end, or, with `here`, what the surface where
  // it is scatters into it; `here` matters if that is the first.
  void receive(int lane, int group, const Vec3f& light, const LobeSplit* here = nullptr);
  // Likewise of light that is a colour, of one wavelength in the camera; or met by a path that
  // nothing has scattered.
  void receive_line(int lane, int group, const Vec3f& light, float wavelength,
                    const SpectrumTable& table, const LobeSplit* here);
  void receive_straight(int lane, int group, const Vec3f& light) {
    add(lane, group, light, Vec3f(0), nullptr);
  }

 private:
  const LobeSplit* first(int lane, const LobeSplit* here) const {
    return has_scattered(lane) ? &first_[lane] : here;
  }
  Vec3f color(int lane, const Vec3f& light) const {
    return by_wavelength_ ? color_from_lanes_[lane] * light : light;
  }
  void add(int lane, int group, const Vec3f& light, const Vec3f& matte, const LobeSplit* here);

  SampleParts* sample_ = nullptr;
  bool by_wavelength_ = false;
  Lanes<std::int32_t> scatterings_;  // so far
  Lanes<LobeSplit> first_;
  Lanes<glm::mat3> color_from_lanes_;
};

}  // namespace restframe

// Which part of their light paths owe to what: their side of PathParts.

#include "tracer/path_parts.h"

#include "tracer/path_walk.h"

namespace restframe {
namespace {

// Of light that is there at all; rounding makes no part of it.
float share(float part, float all) {
  if (!(all > 0.0F)) return 0.0F;
  return part >= all * (1.0F - 0x1p-20F) ? 1.0F : part / all;
}

}  // namespace

void PathParts::receive(int lane, int group, const Vec3f& light, const LobeSplit* here) {
  const LobeSplit* split = first(lane, here);
  Vec3f matte(0);
  for (int i = 0; split != nullptr && i < 3; ++i) {
    if (split->share[i] > 0.0F)
      matte[i] = light[i] * split->share[i];  // of light beyond floats, too
  }
  add(lane, group, color(lane, light), color(lane, matte), here);
}

void PathParts::receive_line(int lane, int group, const Vec3f& light, float wavelength,
                             const SpectrumTable& table, const LobeSplit* here) {
  const LobeSplit* split = first(lane, here);
  if (split == nullptr) return receive_straight(lane, group, light);
  const Vec3f there(table(wavelength / static_cast<float>(split->omega)));
  const float matte = share(glm::dot(there, split->matte), glm::dot(there, split->all));
  add(lane, group, light, light * matte, here);
}

// matte: what of the light the first surface's matte lobes have scattered.
void PathParts::add(int lane, int group, const Vec3f& light, const Vec3f& matte,
                    const LobeSplit* here) {
  sample_->add_to_group(group, lane, light);
  const LobeSplit* split = first(lane, here);
  if (split == nullptr) return sample_->add(LightWay::emission, lane, light);
  if (split->through) return sample_->add(LightWay::transmission, lane, light);
  const bool is_direct = scatterings_[lane] + (here == nullptr ? 0 : 1) == 1;
  sample_->add(is_direct ? LightWay::direct : LightWay::indirect, lane, matte);
  sample_->add(LightWay::reflection, lane, light - matte);
}

// exact: no other lobe than a mirror or clear glass leads there.
LobeSplit PathWalk::lobe_split(int lane, const Vec3f& direction, const Vec3f& all,
                               bool exact) const {
  const BsdfLanes& bsdf = vertices_.bsdf;
  LobeSplit split;
  split.through = glm::dot(bsdf.facet.at(lane), direction) <= 0.0F;
  split.omega = paths_.omega[lane];
  split.all = all;
  split.matte =
      split.through || exact ? Vec3f(0) : matte_fraction(bsdf, vertices_.lobes, lane, direction);
  const Vec3f matte = by_wavelength(lane, split.matte), sum = by_wavelength(lane, all);
  for (int i = 0; i < 3; ++i) split.share[i] = share(matte[i], sum[i]);
  return split;
}

void PathWalk::note_scattering(int lane, const ScatteredLanes& scattered) {
  if (parts_.has_scattered(lane)) return parts_.scatter(lane);
  const float density = scattered.density[lane];
  const bool exact = !(density > 0.0F);
  const Vec3f all = scattered.weight.at(lane) * (exact ? 1.0F : density);
  parts_.scatter(lane, lobe_split(lane, scattered.direction.at(lane), all, exact));
}

// What of the light from one emitter each arrives, and how much is left of it on its way.
void PathWalk::note_arriving(const IncidentLanes& from_light, const Vec3fLanes& fraction,
                             const Vec3fLanes& arriving, const Lanes<std::int32_t>& reached,
                             const Lanes<float>& left) {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (reached[lane] == 0 || !(left[lane] > 0.0F)) continue;
    LobeSplit here{};
    if (!parts_.has_scattered(lane)) {
      here = lobe_split(lane, from_light.direction.at(lane), fraction.at(lane), false);
    }
    parts_.receive(lane, from_light.group[lane], arriving.at(lane) * left[lane], &here);
  }
}

// A colour as denoisers want it: what the first surface looks like in white light, metals by what
// they reflect, and glass white. Of paths that have come to their first surface.
void PathWalk::note_albedos() {
  const BsdfLanes& bsdf = vertices_.bsdf;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (met_[lane] == 0 || parts_.has_scattered(lane)) continue;
    Vec3f albedo;
    if (vertices_.active[lane] != 0) {
      const bool layered = bsdf.layered && bsdf.layers.transmission[lane] > 0.0F;
      const float clear =
          layered ? bsdf.layers.transmission[lane] * (1.0F - bsdf.metallic[lane]) : 0.0F;
      albedo = glm::mix(bsdf.base.at(lane), Vec3f(1), clear);
    } else {
      albedo = base_color(met_surface(lane), texture_[lane], clock_[lane], evaluator_);
    }
    parts_.set_albedo(lane, glm::max(albedo, Vec3f(0)));
  }
}

}  // namespace restframe

#include "tracer/path_walk.h"

namespace restframe {
namespace {

constexpr std::uint32_t most_rounds = 1000;

}  // namespace

PathWalk::PathWalk(const PathStage& stage, const PacketId& id, TemporalEvaluator& evaluator,
                   RayPacket& rays, SurfaceDataLanes* data)
    : stage_(stage), id_(id), evaluator_(evaluator), rays_(rays), data_(data) {
  in_medium_.active.fill(0);
  paths_.throughput.x.fill(1.0F);
  paths_.throughput.y.fill(1.0F);
  paths_.throughput.z.fill(1.0F);
  paths_.radiance.x.fill(0.0F);
  paths_.radiance.y.fill(0.0F);
  paths_.radiance.z.fill(0.0F);
  paths_.coverage.fill(0.0F);
  paths_.scatterings.fill(0);
  if (data_ != nullptr) data_->fill({});
}

void PathWalk::run() {
  for (; round_ < most_rounds; ++round_) {
    if (!find_surfaces()) break;
    met_.fill(0);
    for (int lane = 0; lane < packet_size; ++lane) {
      if (rays_.active[lane] != 0 || in_medium_.active[lane] != 0) stop_or_pass(lane);
    }
    if (any(met_)) meet();
  }
}

void PathWalk::take_radiance(RadianceLanes& radiance) const {
  for (int lane = 0; lane < packet_size; ++lane) {
    radiance[lane] = Vec4f(paths_.radiance.at(lane), paths_.coverage[lane]);
  }
}

// What the next surfaces are, and where exactly; false if no path goes on.
bool PathWalk::find_surfaces() {
  const bool outside = any(rays_.active);
  const bool inside = stage_.has_media && any(in_medium_.active);
  if (outside) stage_.frames.nearest(rays_, hits_);
  if (inside) stage_.frames.nearest(in_medium_, hits_);
  if (!outside && !inside) return false;
  Lanes<std::int32_t> active;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) active[i] = rays_.active[i] | in_medium_.active[i];
  surfaces_at(stage_.scene, stage_.frames, hits_, active, surfaces_);
  stage_.frames.locate(active, hits_, vertices_.at);
  return true;
}

// Objects of one velocity may be in several rest frames, by their sizes.
bool PathWalk::rests_together(int frame, int other) const {
  const auto velocity = [&](int index) {
    return stage_.frames.frame(index).coordinates().from_world.velocity();
  };
  return frame == other || velocity(frame) == velocity(other);
}

void PathWalk::miss(int lane) {
  if (!in_medium(lane)) {
    for (const LightPlace& environment : stage_.environments) {
      const Vec3f radiance =
          environment_radiance(environment, rays_.origin.at(lane), rays_.k.at(lane),
                               stage_.scene.render.beaming, evaluator_);
      paths_.radiance.set(lane, paths_.radiance.at(lane) + paths_.throughput.at(lane) * radiance);
      paths_.coverage[lane] = 1;
    }
  }
  rays_.active[lane] = 0;
  in_medium_.active[lane] = 0;
}

void PathWalk::stop_or_pass(int lane) {
  if (hits_.frame[lane] < 0) return miss(lane);
  if (enters_other_frame(lane)) return;
  const float stopped = stopped_fraction(lane);
  const bool stops =
      stopped >= 1.0F || (stopped > 0.0F && random(lane, Dimension::opacity) < stopped);
  if (!stops) {
    Lanes<double>& s_min = in_medium(lane) ? in_medium_.s_min : rays_.s_min;
    s_min[lane] = stage_.frames.frame(hits_.frame[lane]).s_behind(hits_, lane);
    return;
  }
  met_[lane] = -1;
  if (data_ != nullptr && !(*data_)[lane].hit && paths_.scatterings[lane] == 0) {
    const ObjectPlace& place = stage_.places[static_cast<std::size_t>(surfaces_.object[lane])];
    (*data_)[lane] = surface_data(met_surface(lane), place, rays_);
  }
}

// Media nest only where nothing moves; such a path ends.
bool PathWalk::enters_other_frame(int lane) {
  if (!in_medium(lane)) return false;
  const Medium& medium = media_[lane].top();
  if (rests_together(medium.frame, hits_.frame[lane])) return false;
  crossing_ = {medium.object, surfaces_.object[lane]};
  in_medium_.active[lane] = 0;
  return true;
}

// The fraction of light that does not just pass the surface.
float PathWalk::stopped_fraction(int lane) {
  const PlainMaterial& plain = this->plain(lane);
  if (plain.always) return surfaces_.back[lane] == 0 || plain.double_sided ? 1.0F : 0.0F;
  const MetSurface met = met_surface(lane);
  const ObjectPlace& place = stage_.places[static_cast<std::size_t>(surfaces_.object[lane])];
  clock_[lane] = clock_at(place, hits_, lane);
  texture_[lane] = texel(met, met.material().base_color_texture);
  return coverage(met, texture_[lane].w, clock_[lane], evaluator_);
}

}  // namespace restframe

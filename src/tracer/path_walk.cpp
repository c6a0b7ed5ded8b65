#include "tracer/path_walk.h"

#include "frames/lane_groups.h"
#include "tracer/cover_counts.h"
#include "tracer/shading_normal.h"

namespace restframe {
namespace {

constexpr std::uint32_t most_rounds = 1000;

}  // namespace

PathWalk::PathWalk(const PathStage& stage, const PacketId& id, TemporalEvaluator& evaluator,
                   RayPacket& rays, const SampleLayers& layers)
    : stage_(stage), random_(id), evaluator_(evaluator), rays_(rays), layers_(layers) {
  in_medium_.active.fill(0);
  paths_.throughput.x.fill(1.0F);
  paths_.throughput.y.fill(1.0F);
  paths_.throughput.z.fill(1.0F);
  paths_.radiance.x.fill(0.0F);
  paths_.radiance.y.fill(0.0F);
  paths_.radiance.z.fill(0.0F);
  paths_.coverage.fill(0.0F);
  paths_.scatterings.fill(0);
  for (int i = 0; stage_.tables.has_textures() && i < packet_size; ++i) {
    paths_.cone[i] = {0.0F, rays.has_spread ? rays.spread[i] : 0.0F};
  }
  parts_.begin(layers.parts, stage.groups);
  if (stage.spectra.shifts) choose_wavelengths(id);
  chosen_.density.fill(0.0F);
  for (int i = 0; layers_.data != nullptr && i < packet_size; ++i) (*layers_.data)[i].hit = false;
}

void PathWalk::run() {
  for (; round_ < most_rounds; ++round_) {
    if (!find_surfaces()) break;
    stop_or_pass();
    if (any_active(met_)) meet();
  }
}

// What the next surfaces are, and where exactly; false if no path goes on.
bool PathWalk::find_surfaces() {
  const bool outside = any_active(rays_.active);
  inside_ = stage_.has_media && any_active(in_medium_.active);
  if (!outside && !inside_) return false;
  if (outside) stage_.frames.nearest(rays_, hits_);
  if (inside_) stage_.frames.nearest(in_medium_, hits_);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::int32_t active = rays_.active[i] | in_medium_.active[i];
    const std::int32_t hit = hits_.frame[i] >= 0 ? -1 : 0;
    hit_[i] = hit & active;
    missed_[i] = ~hit & active;
  }
  // What coherent rays hit lies close together.
  if (!rays_.coherent) stage_.frames.prefetch(hit_, hits_);
  surfaces_at(stage_.scene, stage_.frames, hits_, hit_, surfaces_);
  stage_.frames.locate(hit_, stage_.has_clocks || layers_.data != nullptr, hits_, vertices_.at);
  return true;
}

// Objects of one velocity may be in several rest frames, by their sizes.
bool PathWalk::rests_together(int frame, int other) const {
  const auto velocity = [&](int index) {
    return stage_.frames.frame(index).coordinates().from_world.velocity();
  };
  return frame == other || velocity(frame) == velocity(other);
}

void PathWalk::miss() {
  Lanes<std::int32_t> leaving = missed_;
  for (int lane = 0; inside_ && lane < packet_size; ++lane) {
    if (in_medium(lane)) leaving[lane] = 0;
  }
  for (const Environment& sky : stage_.environments) {
    if (sky.uniform && !stage_.spectra.matters) {
      add_uniform(sky, leaving);
      continue;
    }
    for (int lane = 0; lane < packet_size; ++lane) {
      if (leaving[lane] != 0) add_environment(sky, lane);
    }
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    rays_.active[i] &= ~missed_[i];
    in_medium_.active[i] &= ~missed_[i];
  }
}

// Nobody looks for light of such a sky, so all of it is met by chance.
void PathWalk::add_uniform(const Environment& sky, const Lanes<std::int32_t>& leaving) {
  const Vec3f radiance = *sky.uniform;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Vec3f sum = paths_.radiance.at(i) + paths_.throughput.at(i) * radiance;
    set_in(leaving, i, paths_.radiance, sum);
    set_in(leaving, i, paths_.coverage, 1.0F);
  }
  if (!parts_.are_wanted()) return;
  const std::int32_t group = stage_.group_of(sky.place);
  for (int lane = 0; lane < packet_size; ++lane) {
    if (leaving[lane] != 0) parts_.receive(lane, group, paths_.throughput.at(lane) * radiance);
  }
}

void PathWalk::add_environment(const Environment& sky, int lane) {
  Vec3f radiance;
  if (sky.uniform) {
    radiance = *sky.uniform;
  } else {
    radiance = environment_radiance(sky.place, rays_.origin.at(lane), rays_.k.at(lane),
                                    stage_.scene.render.beaming, evaluator_) *
               share_of_sky(sky, lane);
  }
  receive_from_sky(sky, lane, radiance);
  paths_.coverage[lane] = 1;
}

// Sets which paths the surfaces stop; the others pass them, or have met nothing.
void PathWalk::stop_or_pass() {
  if (any_active(missed_)) miss();
  met_.fill(0);
  tilts_ = false;
  for_each_group(surfaces_.material, hit_, [&](int first, const Lanes<std::int32_t>& group) {
    if (plain(first).always && !inside_) return stop_at_plain(plain(first), group);
    for (int lane = 0; lane < packet_size; ++lane) {
      if (group[lane] != 0) stop_or_pass(lane);
    }
  });
  if (layers_.covers != nullptr) count_covers();
  if (layers_.data == nullptr) return;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (met_[lane] != 0 && !(*layers_.data)[lane].hit && paths_.scatterings[lane] == 0) {
      const ObjectPlace& place = stage_.places[static_cast<std::size_t>(surfaces_.object[lane])];
      (*layers_.data)[lane] = surface_data(met_surface(lane), place, rays_);
    }
  }
}

// What stops a path first covers all that the sample stands for.
void PathWalk::count_covers() const {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (met_[lane] == 0 || paths_.coverage[lane] != 0.0F) continue;
    count_cover(stage_.frames, hits_, surfaces_, lane, 1.0F, *layers_.covers);
  }
}

// Back faces that are not to be seen let everything pass.
void PathWalk::stop_at_plain(const PlainMaterial& plain, const Lanes<std::int32_t>& group) {
  const std::int32_t both_sides = plain.double_sided ? -1 : 0;
  Lanes<std::int32_t> passing;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::int32_t stops = surfaces_.back[i] == 0 ? -1 : both_sides;
    met_[i] |= group[i] & stops;
    passing[i] = group[i] & ~stops;
  }
  if (!any_active(passing)) return;
  for (int lane = 0; lane < packet_size; ++lane) {
    if (passing[lane] != 0) pass(lane);
  }
}

void PathWalk::pass(int lane) {
  Lanes<double>& s_min = in_medium(lane) ? in_medium_.s_min : rays_.s_min;
  s_min[lane] = stage_.frames.frame(hits_.frame[lane]).s_behind(hits_, lane);
}

void PathWalk::stop_or_pass(int lane) {
  if (enters_other_frame(lane)) return;
  const MetSurface met = met_surface(lane);
  const ObjectPlace& place = stage_.places[static_cast<std::size_t>(surfaces_.object[lane])];
  clock_[lane] = clock_at(place, hits_, lane);
  texture_[lane] = texel(met, met.material().base_color_texture);
  const float stopped = coverage(met, texture_[lane].w, clock_[lane], evaluator_);
  const bool stops =
      stopped >= 1.0F || (stopped > 0.0F && random(lane, Dimension::opacity) < stopped);
  if (!stops) return pass(lane);
  met_[lane] = -1;
  if (!has_normal_map(met.material())) return;
  tilt_normal(met, clock_[lane], evaluator_, surfaces_);
  tilts_ = true;
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

}  // namespace restframe

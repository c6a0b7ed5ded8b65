// From a packet of world rays to hits in one rest frame: boost, clip to the frame's bounds in
// double, let Embree find the nearest triangle in float.

#include <algorithm>
#include <cmath>

#include "frames/rest_frame.h"
#include "physics/clones.h"

namespace restframe {

struct LocalRays {
  Lanes<double> rest_t;
  Lanes<double> rest_k_t;
  Vec3fLanes sight;
  Vec3Lanes origin, k;
  Lanes<double> s_enter, s_leave;  // where the ray is within the frame's bounds
  // The length of k in rest-frame axes: the light's frequency here, outside of media.
  Lanes<double> omega, inverse_omega;
  Lanes<double> s_of_unit;  // s for one unit of Embree's ray parameter
  Lanes<std::int32_t> active;
};

namespace {

// Narrows [s_enter, s_leave] to a slab of the bounds. k = 0 gives infinities of the right sign, or
// NaN for a ray in the slab's face, which std::min and std::max in this order leave without effect.
inline void clip(double origin, double k, double lower, double upper, double& enter,
                 double& leave) {
  const double inverse = 1.0 / k;
  const double a = (lower - origin) * inverse;
  const double b = (upper - origin) * inverse;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

void clip_to_bounds(const Bounds& bounds, const Lanes<double>& s_min, const Lanes<double>& s_max,
                    const Lanes<std::int32_t>& active, LocalRays& local) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    double enter = s_min[i];
    double leave = s_max[i];
    clip(local.origin.x[i], local.k.x[i], bounds.lower.x, bounds.upper.x, enter, leave);
    clip(local.origin.y[i], local.k.y[i], bounds.lower.y, bounds.upper.y, enter, leave);
    clip(local.origin.z[i], local.k.z[i], bounds.lower.z, bounds.upper.z, enter, leave);
    local.s_enter[i] = enter;
    local.s_leave[i] = leave;
    // False for a ray with a NaN anywhere, which must not reach Embree: it would end the process.
    const bool within = enter <= leave && std::abs(local.rest_t[i]) < 1e300;
    local.active[i] = within ? active[i] : 0;
  }
}

// The origin moves to where the ray enters the bounds, so that floats only hold what is inside. The
// direction is scaled to unit frequency and by the frame's `scale`: high velocities, and meshes placed in
// small, make k longer than floats and Embree's asserts bear. A ray that is not in their range after that is
// dropped.
void narrow(double scale, LocalRays& local, RTCRay16& ray) {
  constexpr double largest = 1e18;
  const double inverse_scale = 1.0 / scale;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double s = local.s_enter[i];
    const double x = local.origin.x[i] + s * local.k.x[i];
    const double y = local.origin.y[i] + s * local.k.y[i];
    const double z = local.origin.z[i] + s * local.k.z[i];
    const double unit = local.inverse_omega[i] * inverse_scale;
    const bool fits = std::abs(x) < largest && std::abs(y) < largest && std::abs(z) < largest &&
                      unit > 0.0 && unit < 1e300;
    local.s_of_unit[i] = unit;
    local.active[i] = fits ? local.active[i] : 0;
    ray.org_x[i] = static_cast<float>(x);
    ray.org_y[i] = static_cast<float>(y);
    ray.org_z[i] = static_cast<float>(z);
    ray.dir_x[i] = static_cast<float>(local.k.x[i] * unit);
    ray.dir_y[i] = static_cast<float>(local.k.y[i] * unit);
    ray.dir_z[i] = static_cast<float>(local.k.z[i] * unit);
    ray.tnear[i] = 0.0F;
    ray.tfar[i] = static_cast<float>((local.s_leave[i] - s) * (local.omega[i] * scale));
    ray.time[i] = 0.0F;
    ray.mask[i] = ~0U;
    ray.id[i] = 0U;
    ray.flags[i] = 0U;
  }
}

// Whether all active rays point into one octant. Embree's traversal of coherent packets loses rays,
// a dozen pixels at a time, where directions of both signs meet.
bool share_an_octant(const LocalRays& local) {
  unsigned signs = 0;  // a bit for each sign of each axis
  for (int i = 0; i < packet_size; ++i) {
    const unsigned of_lane = (local.k.x[i] < 0.0 ? 1U : 2U) | (local.k.y[i] < 0.0 ? 4U : 8U) |
                             (local.k.z[i] < 0.0 ? 16U : 32U);
    signs |= local.active[i] != 0 ? of_lane : 0U;
  }
  return (signs & (signs >> 1) & 0b010101U) == 0U;
}

// With `fresh`, nothing is in `hits` yet, and lanes that hit nothing get numbers that mean nothing.
template <bool fresh, class T>
inline void replace(bool condition, T& value, T by) {
  if constexpr (fresh) {
    value = by;
  } else {
    blend(condition, value, by);
  }
}

template <bool fresh>
void keep_hits(const LocalRays& local, const RTCRayHit16& query, int own_index, HitPacket& hits) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::uint32_t geometry = query.hit.geomID[i];
    const std::uint32_t instance = query.hit.instID[0][i];
    const std::int32_t active = local.active[i];
    const bool hit = (active != 0) & (geometry != RTC_INVALID_GEOMETRY_ID);
    const std::uint32_t part = instance == RTC_INVALID_GEOMETRY_ID ? geometry : instance;
    const double s = local.s_enter[i] + static_cast<double>(query.ray.tfar[i]) * local.s_of_unit[i];
    blend(hit, hits.frame[i], own_index);
    blend(hit, hits.s[i], s);
    replace<fresh>(hit, hits.part[i], part);
    replace<fresh>(hit, hits.triangle[i], query.hit.primID[i]);
    replace<fresh>(hit, hits.bary_u[i], query.hit.u[i]);
    replace<fresh>(hit, hits.bary_v[i], query.hit.v[i]);
    replace<fresh>(hit, hits.facet_normal.x[i], query.hit.Ng_x[i]);
    replace<fresh>(hit, hits.facet_normal.y[i], query.hit.Ng_y[i]);
    replace<fresh>(hit, hits.facet_normal.z[i], query.hit.Ng_z[i]);
    replace<fresh>(hit, hits.sight.x[i], local.sight.x[i]);
    replace<fresh>(hit, hits.sight.y[i], local.sight.y[i]);
    replace<fresh>(hit, hits.sight.z[i], local.sight.z[i]);
    replace<fresh>(hit, hits.rest_t[i], local.rest_t[i]);
    replace<fresh>(hit, hits.rest_k_t[i], local.rest_k_t[i]);
    replace<fresh>(hit, hits.origin.x[i], local.origin.x[i]);
    replace<fresh>(hit, hits.origin.y[i], local.origin.y[i]);
    replace<fresh>(hit, hits.origin.z[i], local.origin.z[i]);
    replace<fresh>(hit, hits.k.x[i], local.k.x[i]);
    replace<fresh>(hit, hits.k.y[i], local.k.y[i]);
    replace<fresh>(hit, hits.k.z[i], local.k.z[i]);
  }
}

// Linear maps commute with s: origins turn as points, wave vectors as vectors.
void turn_to_traversal(const Mat3& linear, LocalRays& local) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    local.origin.set(i, linear * local.origin.at(i));
    local.k.set(i, linear * local.k.at(i));
  }
}

}  // namespace

void RestFrame::set_origins(const EventLanes<in::World>& origin, LocalRays& local) const {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const Displacement<in::Rest> from_anchor =
        coordinates_.from_world(origin.at(i) - coordinates_.anchor);
    local.rest_t[i] = from_anchor.t;
    local.origin.set(i, from_anchor.x - rest_from_traversal_offset_);
  }
}

void RestFrame::set_origin(const Event<in::World>& origin, LocalRays& local) const {
  const Displacement<in::Rest> from_anchor = coordinates_.from_world(origin - coordinates_.anchor);
  const Vec3 place = from_anchor.x - rest_from_traversal_offset_;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    local.rest_t[i] = from_anchor.t;
    local.origin.set(i, place);
  }
}

LocalRays RestFrame::localised(const RayPacket& rays) const {
  LocalRays local;
  if (rays.coherent && rays.one_event) {
    set_origin(rays.origin.at(0), local);
  } else {
    set_origins(rays.origin, local);
  }
  WaveVectorLanes<in::Rest> rest_k;
  transform(coordinates_.from_world, rays.k, rest_k);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const double inverse_omega = -1.0 / rest_k.t[i];
    local.rest_k_t[i] = rest_k.t[i];
    local.omega[i] = -rest_k.t[i];
    local.inverse_omega[i] = inverse_omega;
    local.k.set(i, rest_k.x.at(i));
    local.sight.set(i, Vec3f(rest_k.x.at(i) * inverse_omega));
  }
  if (traversal_is_turned_) turn_to_traversal(traversal_from_rest_linear_, local);
  return local;
}

LocalRays RestFrame::localised(const MediumRayPacket& rays) const {
  LocalRays local;
  set_origins(rays.origin, local);
  for (int i = 0; i < packet_size; ++i) {
    const Displacement<in::Rest> step =
        coordinates_.from_world(Displacement<in::World>{rays.step.t[i], rays.step.x.at(i)});
    const double length = glm::length(step.x);
    local.rest_k_t[i] = step.t;
    local.omega[i] = length;
    local.inverse_omega[i] = 1.0 / length;
    local.k.set(i, step.x);
    local.sight.set(i, Vec3f(step.x / length));
  }
  if (traversal_is_turned_) turn_to_traversal(traversal_from_rest_linear_, local);
  return local;
}

unsigned RestFrame::context_flags(const LocalRays& local, bool coherent) const {
  return coherent && octants_hold_ && share_an_octant(local)
             ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
             : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
}

// Where there are instances, rtcOccluded16 of coherent rays does not always come back (Embree 3.13).
unsigned RestFrame::shadow_flags(const LocalRays& local, bool coherent) const {
  return context_flags(local, coherent && !has_instances_);
}

void RestFrame::find_hits(LocalRays& local, const Lanes<double>& s_min,
                          const Lanes<std::int32_t>& active, bool coherent, bool fresh,
                          int own_index, HitPacket& hits) const {
  clip_to_bounds(bounds_, s_min, hits.s, active, local);
  if (!any_active(local.active)) return;
  RTCRayHit16 query;
  narrow(traversal_scale_, local, query.ray);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = static_cast<RTCIntersectContextFlags>(context_flags(local, coherent));
  rtcIntersect16(&local.active[0], traversed_, &context, &query);
  if (fresh) {
    keep_hits<true>(local, query, own_index, hits);
  } else {
    keep_hits<false>(local, query, own_index, hits);
  }
}

RESTFRAME_CLONES void RestFrame::intersect(const RayPacket& rays, int own_index,
                                           HitPacket& hits) const {
  LocalRays local = localised(rays);
  find_hits(local, rays.s_min, rays.active, rays.coherent, own_index == 0, own_index, hits);
}

void RestFrame::intersect(const MediumRayPacket& rays, int own_index, HitPacket& hits) const {
  LocalRays local = localised(rays);
  find_hits(local, rays.s_min, rays.active, false, false, own_index, hits);
}

RESTFRAME_CLONES void RestFrame::find_blocked(const RayPacket& rays, const Lanes<double>& s_max,
                                              Lanes<std::int32_t>& blocked) const {
  LocalRays local = localised(rays);
  Lanes<std::int32_t> open;
  Lanes<double> s_end;
  const double margin = noise_at_end_;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    open[i] = blocked[i] == 0 ? rays.active[i] : 0;
    s_end[i] = s_max[i] - margin * local.inverse_omega[i];
  }
  clip_to_bounds(bounds_, rays.s_min, s_end, open, local);
  if (!any_active(local.active)) return;
  RTCRay16 query;
  narrow(traversal_scale_, local, query);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = static_cast<RTCIntersectContextFlags>(shadow_flags(local, rays.coherent));
  rtcOccluded16(&local.active[0], traversed_, &context, &query);
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    blocked[i] = local.active[i] != 0 && query.tfar[i] < 0.0F ? -1 : blocked[i];
  }
}

}  // namespace restframe

#pragma once

// Rays and hits, 16 at a time, as structures of arrays that compilers turn into SIMD.

#include <cstdint>
#include <limits>

#include "physics/lorentz.h"

namespace restframe {

inline constexpr int packet_size = 16;

template <class T>
struct alignas(64) Lanes {
  T lane[packet_size];

  T& operator[](int i) { return lane[i]; }
  const T& operator[](int i) const { return lane[i]; }
  void fill(const T& value) {
    for (T& l : lane) l = value;
  }
};

// value = condition ? by : value. Both are there before it is chosen: no lane is read under a mask.
template <class T>
inline void blend(bool condition, T& value, T by) {
  const T before = value;
  value = condition ? by : before;
}

inline bool any_active(const Lanes<std::int32_t>& active) {
  std::int32_t any = 0;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) any |= active[i];
  return any != 0;
}

struct Vec3Lanes {
  Lanes<double> x, y, z;

  Vec3 at(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

struct Vec3fLanes {
  Lanes<float> x, y, z;

  Vec3f at(int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, const Vec3f& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

template <class Frame>
struct EventLanes {
  Lanes<double> t;
  Vec3Lanes x;

  Event<Frame> at(int i) const { return {t[i], x.at(i)}; }
  void set(int i, const Event<Frame>& e) {
    t[i] = e.t;
    x.set(i, e.x);
  }
};

template <class Frame>
struct WaveVectorLanes {
  Lanes<double> t;
  Vec3Lanes x;

  WaveVector<Frame> at(int i) const { return {t[i], x.at(i)}; }
  void set(int i, const WaveVector<Frame>& k) {
    t[i] = k.t;
    x.set(i, k.x);
  }
};

// Boosts 16 wave vectors. Many frames are at rest in the world: those cost nothing.
template <class To, class From>
void transform(const Boost<To, From>& to_from, const WaveVectorLanes<From>& from,
               WaveVectorLanes<To>& to) {
  const Boost<To, From> boost = to_from;
  if (boost.is_identity()) {
#pragma GCC ivdep
    for (int i = 0; i < packet_size; ++i) to.set(i, {from.t[i], from.x.at(i)});
    return;
  }
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) to.set(i, boost(from.at(i)));
}

// Rays traced back in time: points are origin + s k with s > s_min. Inactive lanes find nothing.
struct RayPacket {
  EventLanes<in::World> origin;
  WaveVectorLanes<in::World> k;
  Lanes<double> s_min;         // 0, or where the last surface was passed
  Lanes<std::int32_t> active;  // Embree's convention: -1 active, 0 not
  bool coherent = true;        // close together: from one event, nearly so, or where such rays hit
  bool one_event = false;      // all lanes' origins are the same, as long as they are coherent
  // Where textures are to be filtered: the angle that a camera's ray stands for, in its frame. By
  // this the width of the ray's cone grows with s, in every frame.
  bool has_spread = false;
  Lanes<float> spread;
};

// Light within a medium, traced back in time: points are origin + s step. In the medium's rest
// frame, step is (-n omega, omega direction) with its index n and the light's frequency omega there
// (design, section 2, point 3): it is timelike, and tells no frequency.
struct MediumRayPacket {
  EventLanes<in::World> origin;
  EventLanes<in::World> step;
  Lanes<double> s_min;
  Lanes<std::int32_t> active;
};

inline constexpr std::uint32_t no_part = std::numeric_limits<std::uint32_t>::max();

// The nearest hit of each lane, and the ray in the traversal coordinates of the rest frame that was
// hit.
struct HitPacket {
  Lanes<std::int32_t> frame;      // index into the frame set; -1: nothing is hit
  Lanes<std::uint32_t> part;      // of that rest frame
  Lanes<std::uint32_t> triangle;  // of the part's mesh
  // Distance the light travelled as the camera measures it; Embree's float, from where the ray enters the
  // frame's bounds on, until RestFrame::refine.
  Lanes<double> s;
  Lanes<float> bary_u, bary_v;  // weights of the triangle's second and third corner
  Vec3fLanes facet_normal;      // Embree's: any length, in the coordinates of FramePart::positions
  Vec3fLanes sight;             // unit direction of the ray in rest-frame axes
  Lanes<double> rest_t;         // the ray origin's rest-frame time, and ...
  Lanes<double> rest_k_t;       // ... the wave vector's time part there
  Vec3Lanes origin, k;          // traversal coordinates
};

}  // namespace restframe

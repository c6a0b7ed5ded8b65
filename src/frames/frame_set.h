#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frames/rest_frame.h"

namespace restframe {

// All objects of a scene, grouped by exactly equal velocity (and by size, where sizes differ more
// than floats hold), and the queries across them.
class FrameSet {
 public:
  // `scene` must outlive the set. Throws OutputError if Embree fails.
  FrameSet(const Scene& scene, int threads);

  // The nearest hit over all rest frames: all of them measure along the ray in the same s, so the
  // nearest so far bounds the search in the next (the paper's most recent event). Its s is in
  // double.
  void nearest(const RayPacket& rays, HitPacket& hits) const;

  // Likewise, of what lies before `s_max`.
  void nearest(const RayPacket& rays, const Lanes<double>& s_max, HitPacket& hits) const;

  // Likewise for the active lanes of `rays`; other lanes of `hits` stay. rest_k_t of a hit is the
  // step's time part there.
  void nearest(const MediumRayPacket& rays, HitPacket& hits) const;

  // Sets the lanes of `blocked` (-1) whose ray meets anything before `s_max`.
  void find_blocked(const RayPacket& rays, const Lanes<double>& s_max,
                    Lanes<std::int32_t>& blocked) const;

  // Asks the memory for what the active lanes' hits will be shaded and located with.
  void prefetch(const Lanes<std::int32_t>& active, const HitPacket& hits) const;

  // Gives the hits of the active lanes their s in double, and tells their events. by_clock: as exactly
  // as clocks and textures ask for, else as rays that leave the surfaces do.
  void locate(const Lanes<std::int32_t>& active, bool by_clock, HitPacket& hits,
              HitEvents& events) const;

  // From which s on rays that leave such hits are clear of the surface. direction: unit, in the axes
  // of the hit's rest frame; omega: the rays' frequency there.
  void find_clear(const HitPacket& hits, const HitEvents& from, const Vec3fLanes& direction,
                  const Lanes<double>& omega, const Lanes<std::int32_t>& active,
                  Lanes<double>& s_clear) const;

  // Gives one hit its s in double: for whatever depends on where or when exactly it is.
  void refine(HitPacket& hits, int lane) const { frame(hits.frame[lane]).refine(hits, lane); }

  std::span<const RestFrame> frames() const { return frames_; }
  const RestFrame& frame(int index) const { return frames_[static_cast<std::size_t>(index)]; }
  // What Embree holds, and the most that it held while building.
  std::size_t embree_bytes() const { return device_.bytes_in_use(); }
  std::size_t peak_embree_bytes() const { return device_.peak_bytes(); }

 private:
  EmbreeDevice device_;
  std::vector<TraversableMesh> meshes_;
  std::vector<RestFrame> frames_;
};

}  // namespace restframe

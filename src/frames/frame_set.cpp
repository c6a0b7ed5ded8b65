#include "frames/frame_set.h"

#include "frames/frame_groups.h"
#include "frames/lane_groups.h"

namespace restframe {
namespace {

std::vector<int> count_uses(const Scene& scene) {
  std::vector<int> uses(scene.meshes.size(), 0);
  for (const Object& object : scene.objects) {
    for (const PlacedMesh& part : object.parts) ++uses[static_cast<std::size_t>(part.mesh)];
  }
  return uses;
}

std::size_t part_count(const Scene& scene, const std::vector<int>& group) {
  std::size_t count = 0;
  for (const int i : group) count += scene.objects[static_cast<std::size_t>(i)].parts.size();
  return count;
}

// Instanced meshes need a scene of their own, and so do those that are alone in a rest frame.
std::vector<bool> needs_own_scene(const Scene& scene, const std::vector<std::vector<int>>& groups,
                                  const std::vector<int>& uses) {
  std::vector<bool> needs(scene.meshes.size());
  for (std::size_t i = 0; i < uses.size(); ++i) needs[i] = uses[i] > 1;
  for (const std::vector<int>& group : groups) {
    if (part_count(scene, group) != 1) continue;
    for (const int i : group) {
      for (const PlacedMesh& part : scene.objects[static_cast<std::size_t>(i)].parts) {
        needs[static_cast<std::size_t>(part.mesh)] = true;
      }
    }
  }
  return needs;
}

}  // namespace

FrameSet::FrameSet(const Scene& scene, int threads) : device_(threads) {
  meshes_.reserve(scene.meshes.size());
  for (const Mesh& mesh : scene.meshes) meshes_.push_back(traversable(mesh));
  const std::vector<std::vector<int>> groups = frame_groups(scene, meshes_);
  const std::vector<int> uses = count_uses(scene);
  const std::vector<bool> own_scene = needs_own_scene(scene, groups, uses);
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (own_scene[i]) build_scene(device_, meshes_[i]);
  }
  frames_.reserve(groups.size());
  for (const std::vector<int>& group : groups) {
    frames_.emplace_back(device_, scene, group, meshes_, uses);
  }
}

void FrameSet::nearest(const RayPacket& rays, HitPacket& hits) const {
  Lanes<double> unbounded;
  unbounded.fill(std::numeric_limits<double>::infinity());
  nearest(rays, unbounded, hits);
}

void FrameSet::nearest(const RayPacket& rays, const Lanes<double>& s_max, HitPacket& hits) const {
  hits.frame.fill(-1);
  hits.s = s_max;
  for (int i = 0; i < static_cast<int>(frames_.size()); ++i) {
    frames_[static_cast<std::size_t>(i)].intersect(rays, i, hits);
  }
}

void FrameSet::nearest(const MediumRayPacket& rays, HitPacket& hits) const {
  for (int lane = 0; lane < packet_size; ++lane) {
    if (rays.active[lane] == 0) continue;
    hits.frame[lane] = -1;
    hits.s[lane] = std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < static_cast<int>(frames_.size()); ++i) {
    frames_[static_cast<std::size_t>(i)].intersect(rays, i, hits);
  }
}

void FrameSet::find_blocked(const RayPacket& rays, const Lanes<double>& s_max,
                            Lanes<std::int32_t>& blocked) const {
  blocked.fill(0);
  for (const RestFrame& frame : frames_) frame.find_blocked(rays, s_max, blocked);
}

void FrameSet::prefetch(const Lanes<std::int32_t>& active, const HitPacket& hits) const {
  for (unsigned bits = active_bits(active); bits != 0; bits &= bits - 1) {
    const int i = std::countr_zero(bits);
    frame(hits.frame[i]).part(hits.part[i]).prefetch(hits.triangle[i]);
  }
}

void FrameSet::locate(const Lanes<std::int32_t>& active, bool by_clock, HitPacket& hits,
                      HitEvents& events) const {
  Lanes<std::int32_t> waiting;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) waiting[i] = hits.frame[i] >= 0 ? active[i] : 0;
  if (frames_.size() == 1) {  // keys half as long are told apart twice as fast
    return for_each_group(hits.part, waiting, [&](int first, const Lanes<std::int32_t>& group) {
      frames_[0].locate(hits, first, group, by_clock, events);
    });
  }
  Lanes<std::uint64_t> parts;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    parts[i] = (static_cast<std::uint64_t>(hits.frame[i]) << 32) | hits.part[i];
  }
  for_each_group(parts, waiting, [&](int first, const Lanes<std::int32_t>& group) {
    frame(hits.frame[first]).locate(hits, first, group, by_clock, events);
  });
}

void FrameSet::find_clear(const HitPacket& hits, const HitEvents& from, const Vec3fLanes& direction,
                          const Lanes<double>& omega, const Lanes<std::int32_t>& active,
                          Lanes<double>& s_clear) const {
  if (frames_.size() == 1) return frames_[0].find_clear(from, direction, omega, active, s_clear);
  for_each_group(hits.frame, active, [&](int first, const Lanes<std::int32_t>& group) {
    frame(hits.frame[first]).find_clear(from, direction, omega, group, s_clear);
  });
}

}  // namespace restframe

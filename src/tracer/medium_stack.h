#pragma once

#include <array>
#include <cstdint>

#include "physics/vectors.h"

namespace restframe {

// Something transparent that light is inside of. Without initial values: stacks of it are made for
// every packet, and mostly stay empty.
struct Medium {
  std::int32_t frame;  // rest frame
  std::int32_t object, material;
  float ior;
  Vec3f absorbed;  // per light-second of path, in the medium's rest frame: exp(-absorbed * length)
};

// The media around a point of a path, the innermost on top. Media that overlap count as nested in
// the order in which the path entered them.
class MediumStack {
 public:
  bool empty() const { return count_ == 0; }
  const Medium& top() const { return media_[static_cast<std::size_t>(count_ - 1)]; }
  float ior() const { return empty() ? 1.0F : top().ior; }

  bool full() const { return count_ == static_cast<int>(media_.size()); }
  void enter(const Medium& medium) { media_[static_cast<std::size_t>(count_++)] = medium; }

  // The innermost one of that object and material goes; without one nothing does.
  void leave(std::int32_t object, std::int32_t material) {
    for (int i = count_ - 1; i >= 0; --i) {
      const Medium& medium = media_[static_cast<std::size_t>(i)];
      if (medium.object != object || medium.material != material) continue;
      for (int j = i; j + 1 < count_; ++j) {
        media_[static_cast<std::size_t>(j)] = media_[static_cast<std::size_t>(j + 1)];
      }
      --count_;
      return;
    }
  }

 private:
  std::array<Medium, 8> media_;
  int count_ = 0;
};

}  // namespace restframe

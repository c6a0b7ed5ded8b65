#pragma once

// Surfaces that shine, as lights of which paths choose points. In its own rest frame such a light
// stands still, whatever its velocity: triangles are chosen there, in proportion to their area times
// what they emit, so densities over area are the same for all surfaces that are lit.

#include <array>
#include <vector>

#include "frames/frame_set.h"
#include "tracer/alias_table.h"
#include "tracer/light_sampling.h"

namespace restframe {

// A placed mesh's triangles of one material that shines.
struct EmittingPatch {
  std::int32_t frame = 0;              // rest frame
  std::uint32_t part = 0;              // of that
  std::uint32_t first = 0, count = 0;  // triangles of the part's mesh
  std::int32_t object = 0, material = 0;
  std::uint32_t table = 0;  // of its triangles
};

class Emitters {
 public:
  Emitters() = default;  // nothing shines
  Emitters(const Scene& scene, const FrameSet& frames);

  bool empty() const { return patches_.empty(); }

  struct Chosen {
    const EmittingPatch* patch = nullptr;
    std::uint32_t triangle = 0;  // of the part's mesh
    double chance = 0;
  };
  // Two numbers in [0, 1) choose. There is something to choose from.
  Chosen choose(double u, double v) const;

  // Of the triangle being chosen; 0 where it does not shine.
  double chance(std::int32_t frame, std::uint32_t part, std::uint32_t triangle) const;

  // The rest frame's place as a light's; only of frames in which something shines.
  const LightPlace& place(std::int32_t frame) const {
    return places_[static_cast<std::size_t>(frame)];
  }

 private:
  double chance(std::size_t patch, std::uint32_t triangle) const {
    const std::uint32_t in_table = triangle - patches_[patch].first;
    return chances_.chance(static_cast<std::uint32_t>(patch)) *
           tables_[patches_[patch].table].chance(in_table);
  }

  std::vector<EmittingPatch> patches_;
  AliasTable chances_;              // of the patches
  std::vector<AliasTable> tables_;  // parts that share mesh and material share one
  // By frame and part, its first patch; one more than the frame's parts.
  std::vector<std::vector<std::uint32_t>> first_patches_;
  std::vector<LightPlace> places_;
};

// A triangle as it rests in its frame, in light-seconds.
struct RestTriangle {
  std::array<Vec3, 3> corners;
  Vec3 normal{0};  // unit, to the front
  double area = 0;
};
RestTriangle rest_triangle(const Scene& scene, const FramePart& part, std::uint32_t triangle);

}  // namespace restframe

#pragma once

// Surfaces that shine, as lights of which paths choose points. In its own rest frame such a light
// stands still, whatever its velocity, and so do all that share the frame: there triangles are chosen by
// how they look from the event that is to be lit. First a rest frame is chosen, by the power of all in
// it; then a triangle, by a hierarchy, or by power alone where there are too many for that.

#include <array>
#include <vector>

#include "frames/frame_set.h"
#include "tracer/alias_table.h"
#include "tracer/emitter_tree.h"
#include "tracer/light_sampling.h"

namespace restframe {

// A placed mesh's triangles of one material that shines.
struct EmittingPatch {
  std::int32_t frame = 0;              // rest frame
  std::uint32_t part = 0;              // of that
  std::uint32_t first = 0, count = 0;  // triangles of the part's mesh
  std::int32_t object = 0, material = 0;
  std::uint32_t table = 0;       // of its triangles
  std::uint32_t first_leaf = 0;  // of its frame's tree
};

class Emitters {
 public:
  Emitters() = default;  // nothing shines
  // most_leaves: of a rest frame's hierarchy; 0: none has one.
  Emitters(const Scene& scene, const FrameSet& frames, std::size_t most_leaves = 250'000);

  bool empty() const { return patches_.empty(); }

  // A rest frame in which something shines; u: in [0, 1). There is one.
  std::int32_t choose_frame(double u) const {
    return static_cast<std::int32_t>(frame_chances_.choose(u));
  }

  struct Chosen {
    const EmittingPatch* patch = nullptr;
    std::uint32_t triangle = 0;  // of the part's mesh
    double chance = 0;           // the frame's included; 0: there is none to choose
  };
  // One of the triangles of that frame, for light that is to come to the receiver.
  Chosen choose(std::int32_t frame, const Receiver& receiver, double u) const;

  // Of the triangle being chosen; 0 where it does not shine.
  double chance(std::int32_t frame, std::uint32_t part, std::uint32_t triangle,
                const Receiver& receiver) const;

  // What lies at an event, as the frame has it. facing: in the axes of a surface of `velocity`; what moves
  // past is taken to be lit from all around.
  Receiver receiver(std::int32_t frame, const Event<in::World>& event, const Velocity& velocity,
                    const Vec3f& facing) const;

  // The rest frame's place as a light's; only of frames in which something shines.
  const LightPlace& place(std::int32_t frame) const {
    return frames_[static_cast<std::size_t>(frame)].place;
  }

 private:
  struct FrameEmitters {
    LightPlace place;
    // Of each part, its first patch; one more than the frame's parts.
    std::vector<std::uint32_t> first_patches;
    AliasTable patch_chances;
    EmitterTree tree;  // empty: the tables choose
    std::vector<std::uint32_t> patch_of_leaf;
  };
  void add_tree(const Scene& scene, const RestFrame& frame, FrameEmitters& emitters) const;
  Chosen choose_by_power(const FrameEmitters& emitters, double u) const;
  // Within the patch's rest frame.
  double chance_by_power(const FrameEmitters& emitters, std::uint32_t patch,
                         std::uint32_t triangle) const;

  std::vector<EmittingPatch> patches_;
  std::vector<AliasTable> tables_;  // parts that share mesh and material share one
  std::vector<FrameEmitters> frames_;
  AliasTable frame_chances_;
};

// A triangle as it rests in its frame, in light-seconds.
struct RestTriangle {
  std::array<Vec3, 3> corners;
  Vec3 normal{0};  // unit, to the front
  double area = 0;
};
RestTriangle rest_triangle(const Scene& scene, const FramePart& part, std::uint32_t triangle);

}  // namespace restframe

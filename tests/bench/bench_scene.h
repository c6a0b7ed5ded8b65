#pragma once

#include <string>
#include <vector>

#include "frames/frame_set.h"
#include "scene/scene.h"

namespace restframe {

// The bench lattice: 7 x 7 x 20, pitch 1, balls of radius 0.15 and 1,280 triangles, rods of radius 0.05 and 32
// triangles, one flat mesh of 1,337,952 triangles; 1280 x 720, one sample, beauty only.
Scene bench_scene_at_rest();

// The same at 0.99c, the camera inside the lattice.
Scene bench_scene_moving();

// The bench lattice as a flat GLB, in a folder of its own that goes away with it.
class BenchFile {
 public:
  BenchFile();
  BenchFile(const BenchFile&) = delete;
  BenchFile& operator=(const BenchFile&) = delete;
  ~BenchFile();

  const std::string& folder() const { return folder_; }
  std::string glb() const { return folder_ + "/lattice.glb"; }
  std::string obj() const { return folder_ + "/lattice.obj"; }

 private:
  std::string folder_;
};

// Beauty's primary rays of a scene of one rest frame, as floats in that frame's traversal coordinates, a
// packet a 4 x 4 block of pixels. What the renderer hands to Embree, without the work of getting there.
std::vector<RTCRayHit16> bare_packets(const Scene& scene, const FrameSet& frames);

// rtcIntersect16 over all packets, in parallel as the renderer does it. Returns how many lanes hit.
std::size_t trace_bare(const FrameSet& frames, const std::vector<RTCRayHit16>& packets);

}  // namespace restframe

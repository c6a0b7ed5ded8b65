#pragma once

#include <cstddef>

#include "frames/frame_set.h"
#include "scene/scene.h"

namespace restframe {

// What rendering pictures of a scene asks of a machine.
struct JobNeeds {
  std::size_t bytes = 0;  // of memory, with a margin
  int cores = 1;          // that it makes good use of
};

// A picture's worth of cores is a matter of taste, as pictures are independent: as many as go with
// the memory on common machines (2 GB each), at least 4, at most 32, and no more than tiles.
JobNeeds needs_of(const Scene& scene, const FrameSet& frames);

}  // namespace restframe

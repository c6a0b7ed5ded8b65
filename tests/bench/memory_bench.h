#pragma once

namespace restframe {

struct MemoryUse {
  double peak_megabytes = 0;  // of `restframe render` of the bench lattice's GLB, the whole process
  double needed_megabytes = 0;  // vertices, indices, and the most that Embree says it held
};

// To be called before anything large is made.
MemoryUse measure_memory();

}  // namespace restframe

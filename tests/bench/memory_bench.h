#pragma once

#include <string>

namespace restframe {

struct MemoryUse {
  double peak_megabytes = 0;  // of `restframe render` of the bench lattice's GLB, the whole process
  double needed_megabytes = 0;  // vertices, indices, and the most that Embree says it held
};

// To be called before anything large is made.
MemoryUse measure_memory();

// The most that load_asset takes in a process of its own, and the size of what it returns.
struct ImportMemory {
  double peak_megabytes = 0, kept_megabytes = 0;
};
ImportMemory measure_import(const std::string& path);

}  // namespace restframe

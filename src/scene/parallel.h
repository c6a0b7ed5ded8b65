#pragma once

#include <cstddef>
#include <functional>

namespace restframe {

// The one seam through which all parallel loops go: oneTBB, or plain threads in the
// thread-sanitizer build.

// 0: as many as there are cores. Holds for the whole process; the last call counts.
void set_thread_count(int threads);
int thread_count();

// Calls body(i) for every i in [0, count), in any order, on any thread, each with denormals flushed
// to zero. Waits for all. The first exception is rethrown here.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace restframe

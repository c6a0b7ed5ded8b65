#include "scene/parallel.h"

#include <immintrin.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#ifndef RESTFRAME_THREADS_ONLY
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace restframe {
namespace {

int requested_threads = 0;

// Embree asks for this on every thread that calls it; a denormal costs a hundred cycles.
void flush_denormals() {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

}  // namespace

int thread_count() {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return requested_threads > 0 ? requested_threads : cores;
}

#ifdef RESTFRAME_THREADS_ONLY

void set_thread_count(int threads) {
  requested_threads = threads;
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    flush_denormals();
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < thread_count(); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

#else

void set_thread_count(int threads) {
  static std::unique_ptr<tbb::global_control> control;
  requested_threads = threads;
  control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(thread_count()));
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  // An arena of the wanted size: more threads than cores, where a test asks for them. Embree's device may
  // have limited all of TBB to the cores; TBB writes a warning where an arena asks for more.
  const std::size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(std::min(thread_count(), static_cast<int>(allowed)));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      flush_denormals();
      body(i);
    });
  });
}

#endif

}  // namespace restframe

#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>

namespace restframe {

// A line on a terminal, rewritten a few times a second: pictures done, samples a second, time left.
// On anything else, and when quiet, nothing.
class Progress {
 public:
  Progress(std::size_t pictures, std::size_t samples_a_picture, bool quiet);
  ~Progress();

  void samples_done(std::size_t samples);                        // from any thread
  void skip(std::size_t samples) { total_samples_ -= samples; }  // they were there already
  void picture_done() { ++pictures_done_; }

 private:
  void draw();

  using Clock = std::chrono::steady_clock;
  bool shown_;
  std::size_t pictures_;
  std::atomic<std::size_t> total_samples_, pictures_done_{0}, samples_{0};
  Clock::time_point start_;
  std::mutex drawing_;
  Clock::time_point last_drawn_;
};

}  // namespace restframe

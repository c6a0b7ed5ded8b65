#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace restframe {
namespace {

constexpr int bar_width = 30;

std::string time_text(double seconds) {
  const auto whole = std::lround(seconds);
  return whole < 60 ? fmt::format("{} s", whole)
                    : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(std::size_t pictures, std::size_t samples_a_picture, bool quiet)
    : shown_(!quiet && isatty(STDERR_FILENO) != 0),
      pictures_(pictures),
      total_samples_(pictures * samples_a_picture),
      start_(Clock::now()),
      last_drawn_(start_) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::samples_done(std::size_t samples) {
  samples_ += samples;
  if (!shown_) return;
  const std::unique_lock lock(drawing_, std::try_to_lock);
  if (!lock || Clock::now() - last_drawn_ < std::chrono::milliseconds(200)) return;
  last_drawn_ = Clock::now();
  draw();
}

void Progress::draw() {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = static_cast<double>(samples_) / seconds;
  const double part = static_cast<double>(samples_) / static_cast<double>(total_samples_);
  const auto filled = static_cast<std::size_t>(bar_width * part);
  fmt::print(stderr, "\r\033[K[{:<{}}] picture {} of {}, {:.1f} million samples/s, {} left",
             std::string(filled, '='), bar_width, pictures_done_ + 1, pictures_, rate * 1e-6,
             time_text(seconds * (1.0 - part) / part));
  std::fflush(stderr);
}

}  // namespace restframe

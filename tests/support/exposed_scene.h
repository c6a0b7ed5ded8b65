#pragma once

// One small thing far off on a camera's axis, for pictures of which closed forms tell the moments.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "physics/vectors.h"
#include "support/exr_reader.h"

namespace restframe {

// A film whose pixels are 1/focal_length apart in tangents.
struct Film {
  int width = 64, height = 64;
  double focal_length = 100;  // pixels

  double fov() const { return 2 * std::atan(0.5 * height / focal_length) * 180 / std::numbers::pi; }
  // [render] and [output]. With `beaming` pictures are in float; at rest they are no brighter.
  std::string text(int samples, bool beaming = false,
                   const std::string& layers = R"(["beauty"])") const {
    return fmt::format(
        "[render]\nresolution = [{}, {}]\nsamples = {}\nbeaming = {}\n[output]\nlayers = "
        "{}\npreview = false\n",
        width, height, samples, beaming, layers);
  }
};

// What a channel of non-negative values weighs, in pixels from the picture's middle.
struct ChannelMoments {
  double sum = 0, mean_x = 0, mean_y = 0, mean_square = 0;  // of the distance from the middle
};

inline ChannelMoments moments_of(const ExrPicture& picture, const std::string& channel, int first_x,
                                 int last_x, int first_y, int last_y) {
  ChannelMoments m;
  for (int y = first_y; y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      const double value = static_cast<double>(picture.at(channel, x, y));
      const double dx = x + 0.5 - 0.5 * picture.width;
      const double dy = y + 0.5 - 0.5 * picture.height;
      m.sum += value;
      m.mean_x += value * dx;
      m.mean_y += value * dy;
      m.mean_square += value * (dx * dx + dy * dy);
    }
  }
  m.mean_x /= m.sum;
  m.mean_y /= m.sum;
  m.mean_square /= m.sum;
  return m;
}

inline ChannelMoments moments_of(const ExrPicture& picture, const std::string& channel) {
  return moments_of(picture, channel, 0, picture.width - 1, 0, picture.height - 1);
}

// Closed form 1: how long light takes from a point that is at `now` and moves with `v`.
inline double delay_of(const Vec3& now, const Vec3& v) {
  const double gamma_squared = 1 / (1 - glm::dot(v, v));
  const double along = glm::dot(now, v);
  return gamma_squared * (-along + std::sqrt(along * along + glm::dot(now, now) / gamma_squared));
}

// Where a point is seen from the origin at `time` that passes `place` at time 0.
inline Vec3 seen_at(const Vec3& place, const Vec3& v, double time) {
  const Vec3 now = place + v * time;
  return now - v * delay_of(now, v);
}

}  // namespace restframe

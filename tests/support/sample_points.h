#pragma once

// Points of the samples of a pixel.

#include <cstdint>

#include "tracer/random.h"

namespace restframe {

struct SamplePoint {
  double u, v;
};

inline PacketId packet(std::uint32_t sample_bits, std::uint64_t seed = 3) {
  PacketId id;
  id.seed = seed;
  id.picture = 2;
  id.sample_bits = sample_bits;
  for (int i = 0; i < packet_size; ++i) id.pixel[i] = 4096U + static_cast<std::uint32_t>(i);
  return id;
}

inline SamplePoint point_of(PacketId& id, int lane, std::uint32_t sample, std::uint32_t index = 0) {
  id.sample = sample;
  return {static_cast<double>(random_unit(id, lane, Dimension::direction_u, index)),
          static_cast<double>(random_unit(id, lane, Dimension::direction_v, index))};
}

}  // namespace restframe

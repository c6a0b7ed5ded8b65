#pragma once

#include <cstdint>

#include "frames/packet.h"

namespace restframe {

// Counter-based random numbers: each is a function of what it is for, so that pictures do not depend on
// the order in which threads come by.
struct PacketId {
  std::uint64_t seed = 0;
  std::uint32_t picture = 0;
  std::uint32_t sample = 0;
  Lanes<std::uint32_t> pixel;  // number in the picture, row by row
};

// What a number is drawn for; keeps uses independent of each other.
enum class Dimension : std::uint32_t {
  opacity,
  time,
  lens,
  lobe,
  direction_u,
  direction_v,
  survival,
  emitter_patch,
  emitter_patch_digits,
  emitter_triangle,
  emitter_triangle_digits,
  emitter_u,
  emitter_v,
  sky_u,
  sky_v,
  wavelength
};

// Steele and others' SplitMix64 finaliser: every input bit reaches every output bit.
inline std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// In [0, 1). index: tells numbers of one dimension apart, below 2^24.
inline float random_unit(const PacketId& id, int lane, Dimension dimension, std::uint32_t index) {
  const std::uint64_t where = (std::uint64_t{id.picture} << 32) | id.pixel[lane];
  const std::uint64_t what = (std::uint64_t{id.sample} << 32) |
                             (std::uint64_t{static_cast<std::uint32_t>(dimension)} << 24) | index;
  const std::uint64_t bits = mixed(mixed(mixed(id.seed + 0x9e3779b97f4a7c15ULL) ^ where) + what);
  return static_cast<float>(bits >> 40) * 0x1p-24F;
}

}  // namespace restframe

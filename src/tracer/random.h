#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "frames/packet.h"
#include "tracer/low_discrepancy.h"

namespace restframe {

// Counter-based random numbers: each is a function of what it is for, so that pictures do not depend
// on the order in which threads come by.
//
// Each is uniform, but those of one use are no strangers to each other: over the samples of a pixel
// they fill the unit interval (or square, or cube) evenly, and over neighbouring pixels, too, so that what
// remains of error is fine-grained (Ahmed and Wonka 2020, "Screen-space blue-noise diffusion of Monte
// Carlo sampling error via hierarchical ordering of pixels"). For this, the samples of all pixels are
// consecutive points of one sequence, pixels in Morton's order, 2^sample_bits points a pixel; each use
// has them in an order and with a scrambling of its own ("padding": Burley 2020).
struct PacketId {
  std::uint64_t seed = 0;
  std::uint32_t picture = 0;
  std::uint32_t replicate = 0;     // those of one picture are independent of each other
  std::uint32_t sample = 0;        // below 2^sample_bits
  std::uint32_t sample_bits = 32;  // so that 2^sample_bits is the most samples of a pixel
  Lanes<std::uint32_t> pixel;      // morton_place()
};

// The least bits that number so many samples.
inline int bits_for(int samples) {
  return std::bit_width(static_cast<unsigned>(samples) - 1U);
}

// What a number is drawn for; keeps uses independent of each other. New ones come at the end, before
// `count`.
enum class Dimension : std::uint32_t {
  opacity,
  time,
  direction_u,
  direction_v,
  lobe,
  survival,
  film_u,
  film_v,
  lens_u,
  lens_v,
  emitter_u,
  emitter_v,
  emitter_triangle,
  emitter_frame,
  emitter_triangle_digits,
  sky_u,
  sky_v,
  wavelength,
  count
};

// Dimensions that are used together make a set of two to four that follow each other, which fill the
// unit square or cube evenly: where a lobe is chosen by chance, the directions of each lobe still do.
// (With choices that are strangers to what is chosen for, nothing is left of the gain.) The first two
// are the best. The place of a dimension in its set: 0 of what begins one, or is alone.
constexpr std::uint32_t place_in_set(Dimension dimension) {
  switch (dimension) {
    case Dimension::direction_v:
    case Dimension::film_v:
    case Dimension::lens_v:
    case Dimension::emitter_v:
    case Dimension::sky_v:
      return 1;
    case Dimension::lobe:
    case Dimension::emitter_triangle:
      return 2;
    case Dimension::emitter_frame:
      return 3;
    default:
      return 0;
  }
}

constexpr Dimension first_of_set(Dimension dimension) {
  return static_cast<Dimension>(static_cast<std::uint32_t>(dimension) - place_in_set(dimension));
}

constexpr std::size_t size_of_set(Dimension first) {
  auto after = static_cast<std::uint32_t>(first) + 1;
  while (after < static_cast<std::uint32_t>(Dimension::count) &&
         place_in_set(static_cast<Dimension>(after)) > 0) {
    ++after;
  }
  return after - static_cast<std::uint32_t>(first);
}

// Steele and others' SplitMix64 finaliser: every input bit reaches every output bit.
inline std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// The place of a sample in the sequence of all pixels' samples. Beyond 2^32, the sequence begins anew
// with other seeds.
struct SequencePlace {
  std::uint32_t index_reversed;
  std::uint32_t seed;
};

inline SequencePlace place_in_sequence(std::uint32_t pixel, std::uint32_t sample,
                                       std::uint32_t sample_bits) {
  const std::uint64_t place = (std::uint64_t{pixel} << sample_bits) | sample;
  // Wellons' lowbias32 (2018), which leaves 0 as it is.
  auto seed = static_cast<std::uint32_t>(place >> 32);
  seed = (seed ^ (seed >> 16)) * 0x7feb352dU;
  seed = (seed ^ (seed >> 15)) * 0x846ca68bU;
  return {bits_reversed(static_cast<std::uint32_t>(place)), seed ^ (seed >> 16)};
}

// The seeds of one use of random numbers, alike for all pixels and samples.
struct UseSeeds {
  std::uint32_t order;
  std::array<std::uint32_t, 4> place;  // of the dimension's place in its set
};

// dimension: the first of its set.
inline UseSeeds seeds_of(const PacketId& id, Dimension dimension, std::uint32_t index) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
  const std::uint64_t what =
      (std::uint64_t{static_cast<std::uint32_t>(dimension)} << 24) | std::uint64_t{index};
  const std::uint64_t where = (std::uint64_t{id.picture} << 32) | id.replicate;
  const std::uint64_t bits = mixed(mixed(mixed(id.seed + golden) ^ where) + golden * (what + 1));
  const std::uint64_t more = mixed(bits + golden);
  return {static_cast<std::uint32_t>(bits >> 32),
          {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(more >> 32),
           static_cast<std::uint32_t>(more), static_cast<std::uint32_t>(mixed(more + golden))}};
}

// In [0, 1). index: tells numbers of one dimension apart, below 2^24.
inline float random_unit(const PacketId& id, int lane, Dimension dimension, std::uint32_t index) {
  const SequencePlace place = place_in_sequence(id.pixel[lane], id.sample, id.sample_bits);
  const UseSeeds seeds = seeds_of(id, first_of_set(dimension), index);
  const std::uint32_t at = place_in_set(dimension);
  std::uint32_t point = shuffled_index(place.index_reversed, seeds.order ^ place.seed);
  if (at == 1) point = sobol_second_reversed(point);
  if (at == 2) point = sobol_reversed(sobol_third, point);
  if (at == 3) point = sobol_reversed(sobol_fourth, point);
  return scrambled_unit(point, seeds.place[at] ^ place.seed);
}

// The numbers of random_unit() for 16 samples, drawn for all lanes at once, and sets together up to the
// number that is asked for: a fraction of the time where most lanes ask. The id must outlive it, as it is.
class PacketRandom {
 public:
  explicit PacketRandom(const PacketId& id) : id_(id) { drawn_.fill(0); }

  float operator()(int lane, Dimension dimension, std::uint32_t index) {
    const auto at = static_cast<std::size_t>(dimension);
    if (drawn_[at] != index + 1) draw(dimension, index);
    return units_[at][lane];
  }
  const Lanes<float>& lanes(Dimension dimension, std::uint32_t index) {
    (void)(*this)(0, dimension, index);
    return units_[static_cast<std::size_t>(dimension)];
  }

 private:
  // With those before it in its set.
  void draw(Dimension last, std::uint32_t index);

  static constexpr auto dimensions = static_cast<std::size_t>(Dimension::count);
  const PacketId& id_;
  bool placed_ = false;
  Lanes<std::uint32_t> index_reversed_, seed_;
  std::array<std::uint32_t, dimensions> drawn_;  // the index that is there, plus 1; 0: none yet
  std::array<Lanes<float>, dimensions> units_;
};

}  // namespace restframe

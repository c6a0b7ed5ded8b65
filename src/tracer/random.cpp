#include "tracer/random.h"

#include "physics/clones.h"

namespace restframe {
namespace {

using BitLanes = Lanes<std::uint32_t>;

RESTFRAME_CLONES void place_lanes(const PacketId& id, BitLanes& index_reversed, BitLanes& seed) {
  const std::uint32_t sample = id.sample;
  const std::uint32_t sample_bits = id.sample_bits;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const SequencePlace place = place_in_sequence(id.pixel[i], sample, sample_bits);
    index_reversed[i] = place.index_reversed;
    seed[i] = place.seed;
  }
}

// The points' places in the order of one use.
RESTFRAME_CLONES void shuffle_lanes(const BitLanes& index_reversed, const BitLanes& seed,
                                    std::uint32_t order, BitLanes& points) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    points[i] = shuffled_index(index_reversed[i], order ^ seed[i]);
  }
}

RESTFRAME_CLONES void first_lanes(const BitLanes& points, const BitLanes& seed, std::uint32_t use,
                                  Lanes<float>& units) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) units[i] = scrambled_unit(points[i], use ^ seed[i]);
}

RESTFRAME_CLONES void second_lanes(const BitLanes& points, const BitLanes& seed, std::uint32_t use,
                                   Lanes<float>& units) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    units[i] = scrambled_unit(sobol_second_reversed(points[i]), use ^ seed[i]);
  }
}

RESTFRAME_CLONES void third_lanes(const BitLanes& points, const BitLanes& seed, std::uint32_t use,
                                  Lanes<float>& units) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    units[i] = scrambled_unit(sobol_reversed(sobol_third, points[i]), use ^ seed[i]);
  }
}

RESTFRAME_CLONES void fourth_lanes(const BitLanes& points, const BitLanes& seed, std::uint32_t use,
                                   Lanes<float>& units) {
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    units[i] = scrambled_unit(sobol_reversed(sobol_fourth, points[i]), use ^ seed[i]);
  }
}

}  // namespace

void PacketRandom::draw(Dimension last, std::uint32_t index) {
  if (!placed_) place_lanes(id_, index_reversed_, seed_);
  placed_ = true;
  const Dimension first = first_of_set(last);
  const auto at = static_cast<std::size_t>(first);
  const std::size_t size = place_in_set(last) + std::size_t{1};
  const UseSeeds seeds = seeds_of(id_, first, index);
  BitLanes points;
  shuffle_lanes(index_reversed_, seed_, seeds.order, points);
  first_lanes(points, seed_, seeds.place[0], units_[at]);
  if (size > 1) second_lanes(points, seed_, seeds.place[1], units_[at + 1]);
  if (size > 2) third_lanes(points, seed_, seeds.place[2], units_[at + 2]);
  if (size > 3) fourth_lanes(points, seed_, seeds.place[3], units_[at + 3]);
  for (std::size_t i = at; i < at + size; ++i) drawn_[i] = index + 1;
}

}  // namespace restframe

#include "tracer/random.h"

#include "physics/clones.h"

namespace restframe {
namespace {

RESTFRAME_CLONES void place_lanes(const PacketId& id, Lanes<std::uint32_t>& index_reversed,
                                  Lanes<std::uint32_t>& seed) {
  const std::uint32_t sample = id.sample;
  const std::uint32_t sample_bits = id.sample_bits;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const SequencePlace place = place_in_sequence(id.pixel[i], sample, sample_bits);
    index_reversed[i] = place.index_reversed;
    seed[i] = place.seed;
  }
}

struct PlaceLanes {
  const Lanes<std::uint32_t>&index_reversed, &seed;
};

RESTFRAME_CLONES void draw_one(const PlaceLanes& places, const UseSeeds& use, Lanes<float>& units) {
  const UseSeeds seeds = use;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::uint32_t own = places.seed[i];
    const std::uint32_t point = shuffled_index(places.index_reversed[i], seeds.order ^ own);
    units[i] = scrambled_unit(point, seeds.first ^ own);
  }
}

RESTFRAME_CLONES void draw_pair(const PlaceLanes& places, const UseSeeds& use, Lanes<float>& first,
                                Lanes<float>& second) {
  const UseSeeds seeds = use;
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    const std::uint32_t own = places.seed[i];
    const std::uint32_t point = shuffled_index(places.index_reversed[i], seeds.order ^ own);
    first[i] = scrambled_unit(point, seeds.first ^ own);
    second[i] = scrambled_unit(sobol_second_reversed(point), seeds.second ^ own);
  }
}

}  // namespace

void PacketRandom::draw(Dimension first, std::uint32_t index) {
  if (!placed_) place_lanes(id_, index_reversed_, seed_);
  placed_ = true;
  const auto at = static_cast<std::size_t>(first);
  const UseSeeds seeds = seeds_of(id_, first, index);
  drawn_[at] = index + 1;
  const bool pair = at + 1 < dimensions && is_second(static_cast<Dimension>(at + 1));
  if (!pair) return draw_one({index_reversed_, seed_}, seeds, units_[at]);
  drawn_[at + 1] = index + 1;
  draw_pair({index_reversed_, seed_}, seeds, units_[at], units_[at + 1]);
}

}  // namespace restframe

#pragma once

// Mattes that compositors pick by name: Cryptomatte 1.2. A name's hash is its id; a pixel holds the ids
// of what covers most of it, each with how much, and the header tells which name has which id.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "tracer/cover_counts.h"

namespace restframe {

// MurmurHash3_x86_32 with seed 0 (Austin Appleby 2011).
std::uint32_t murmur3_32(std::string_view bytes);

// The name's hash as the bits of a float that is finite, normal and not 0, so that no program
// rounds or drops it on its way.
std::uint32_t matte_id(std::string_view name);

// Manifests are UTF-8. A name that is not is taken as Latin-1, as old files have it.
std::string utf8_name(const std::string& name);

// The ids of the kinds that the scene's layers ask for.
MatteIds matte_ids(const Scene& scene);

struct MatteRank {
  float id = 0, coverage = 0;
};
using MatteRanks = std::array<MatteRank, 6>;

// The largest, in falling order; those of one size by their ids. samples: of the pixel, of all exposures.
MatteRanks matte_ranks(std::span<const Cover> covers, double samples);

// "crypto_object00.R" and so on: two ranks in each four.
std::vector<std::string> matte_channels(const std::string& layer);

// What the header says of the scene's mattes: name and text of each attribute.
std::vector<std::pair<std::string, std::string>> cryptomatte_texts(const Scene& scene);

}  // namespace restframe

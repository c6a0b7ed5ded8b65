#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/job.h"
#include "app/provenance.h"
#include "film/part_file.h"

namespace restframe {

// Where the tiles of a picture, or of a share of it, are kept until it is whole: "p.0007.exr.part"; and where
// one of several machines leaves its share of them: "p.0007.exr.part-03-of-16".
std::filesystem::path checkpoint_path(const std::filesystem::path& picture);
std::filesystem::path share_path(const std::filesystem::path& picture, const TileShare& share);

// Those of a picture's shares that are there.
struct FoundShare {
  std::filesystem::path path;
  TileShare share;
};
std::vector<FoundShare> shares_of(const std::filesystem::path& picture);

// Which of so many tiles make up a share: every so manieth, so that all shares take about as long.
std::vector<std::size_t> tiles_of(const TileShare& share, std::size_t tiles);

PartInfo part_info(const Provenance& provenance, int number);

// Why a part file does not belong to the picture that `now` describes, in words; empty if it does.
std::string difference(const PartInfo& before, const PartInfo& now);

// Those of these pictures of which not all of the share is there. A part file of another scene is an
// InputError, checkpoints of whole pictures (no share) too.
std::vector<int> pictures_with_tiles_to_make(const Job& job, const std::vector<int>& numbers,
                                             const std::optional<TileShare>& share);

}  // namespace restframe

#pragma once

// Part files: pictures of which only some tiles are done, as they are in memory, with all their digits.
// Checkpoints of long pictures, and what several machines make of one picture.

#include <atomic>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "film/picture.h"
#include "film/tile_marks.h"

namespace restframe {

// What a part file says of its picture.
struct PartInfo {
  int number = 0;
  std::vector<std::pair<std::string, std::string>> texts;  // what made it: names and values
};

// One view of the picture: all of its tiles, and which of them are done.
struct PartView {
  std::string name;
  Picture& picture;
  std::span<const PixelWindow> tiles;
  TileMarks& done;
};

// Writes the tiles that are marked now, while others may be rendered; whole under its name or not at all.
// Returns false, having written nothing, where `stop` was set meanwhile. Throws OutputError.
bool write_part(const std::filesystem::path& path, const PartInfo& info,
                std::span<const PartView> views, const std::atomic<bool>& stop);

struct PartSummary {
  PartInfo info;
  std::vector<std::vector<std::size_t>> done;  // tiles of each view
};

// Reads all of it, to see whether it is whole; nothing where it is missing, torn, or of another make.
std::optional<PartSummary> part_summary(const std::filesystem::path& path);

// Fills in the tiles of a part file and marks them. Nothing is marked, and nothing returned, where it is
// missing, torn, or does not fit these views.
std::optional<PartInfo> read_part(const std::filesystem::path& path,
                                  std::span<const PartView> views);

}  // namespace restframe

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace restframe {

// A grid of small pictures, rows from the top left. Lengths in pixels.
struct SheetLayout {
  int columns = 1, rows = 1;
  int cell_width = 1, cell_height = 1;
  int width() const { return columns * cell_width + (columns + 1) * gap; }
  int height() const { return rows * cell_height + (rows + 1) * gap; }
  int cell_x(std::size_t cell) const;  // the left edge of a cell
  int cell_y(std::size_t cell) const;  // its top
  static constexpr int gap = 4;
};

// For `count` pictures (at least 1) of this size: at most 1600 wide, half as wide again as high if
// that can be; no picture grows.
SheetLayout sheet_layout(std::size_t count, int picture_width, int picture_height);

// At most `most` (2 or more) of the numbers 0 to count - 1, evenly spread, the first and the last
// among them.
std::vector<std::size_t> evenly_chosen(std::size_t count, std::size_t most);

// How many pictures a sheet shows at most.
inline constexpr std::size_t largest_sheet = 400;

// The PNGs, all of this size, on one picture in their order, scaled down in linear light. Throws
// InputError where one of them is missing or something else, OutputError, and Interrupted.
void write_contact_sheet(const std::filesystem::path& sheet,
                         std::span<const std::filesystem::path> pngs, int picture_width,
                         int picture_height);

}  // namespace restframe

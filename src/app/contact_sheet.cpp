#include "app/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "app/picture_files.h"
#include "app/signals.h"
#include "film/png_preview.h"
#include "importers/importers.h"
#include "scene/color.h"
#include "scene/error.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

constexpr int most_width = 1600;
constexpr double sheet_shape = 1.5;  // width over height
constexpr std::uint8_t gap_grey = 56;

// Linear light of each byte of an sRGB picture.
const std::array<float, 256>& linear_of_byte() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = linear_from_srgb(Vec3f(static_cast<float>(i) / 255.0F)).x;
    }
    return values;
  }();
  return table;
}

// The pixels of a row that one smaller pixel covers, and how much of it the first and last fill.
struct Cover {
  int first, last;
  float first_part, last_part;
  float part(int i) const { return i == first ? first_part : i == last ? last_part : 1.0F; }
};

std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> all;
  for (int i = 0; i < to; ++i) {
    const double begin = static_cast<double>(i) * from / to;
    const double end = static_cast<double>(i + 1) * from / to;
    const int first = static_cast<int>(begin);
    const int last = std::max(first, std::min(static_cast<int>(std::ceil(end)), from) - 1);
    const double first_end = std::min(end, first + 1.0);
    all.push_back(
        {first, last, static_cast<float>(first_end - begin), static_cast<float>(end - last)});
  }
  return all;
}

// What a smaller pixel covers, averaged in linear light (a box filter).
Vec3f mean_of(const Image& image, const Cover& columns, const Cover& rows) {
  const auto& linear = linear_of_byte();
  Vec3f sum(0);
  float weight = 0;
  for (int y = rows.first; y <= rows.last; ++y) {
    Vec3f row(0);
    float row_weight = 0;
    for (int x = columns.first; x <= columns.last; ++x) {
      const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x));
      const float part = columns.part(x);
      row += part *
             Vec3f(linear[image.rgba[at]], linear[image.rgba[at + 1]], linear[image.rgba[at + 2]]);
      row_weight += part;
    }
    sum += rows.part(y) * row;
    weight += rows.part(y) * row_weight;
  }
  return sum / weight;
}

Image loaded_preview(const std::filesystem::path& png, int width, int height) {
  const std::string content = file_content(png);
  const std::vector<std::uint8_t> bytes(content.begin(), content.end());
  ImportLimits limits;
  limits.image_pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Image image = decode_image(bytes, png.string(), limits);
  if (image.width != width || image.height != height) {
    throw InputError(
        fmt::format("{}: is {} x {} pixels, its picture {} x {}; --overwrite makes both "
                    "again",
                    png.string(), image.width, image.height, width, height));
  }
  return image;
}

// A cell of the sheet, at `corner` of its bytes.
void draw_cell(const Image& image, const SheetLayout& layout, std::uint8_t* corner) {
  const std::vector<Cover> columns = covers(image.width, layout.cell_width);
  const std::vector<Cover> rows = covers(image.height, layout.cell_height);
  for (const Cover& row : rows) {
    std::uint8_t* to = corner;
    for (const Cover& column : columns) {
      const Vec3f encoded = 255.0F * srgb_from_linear(mean_of(image, column, row));
      for (int i = 0; i < 3; ++i) {
        *to++ = static_cast<std::uint8_t>(std::lround(std::clamp(encoded[i], 0.0F, 255.0F)));
      }
    }
    corner += 3 * static_cast<std::ptrdiff_t>(layout.width());
  }
}

}  // namespace

int SheetLayout::cell_x(std::size_t cell) const {
  return gap + static_cast<int>(cell % static_cast<std::size_t>(columns)) * (cell_width + gap);
}

int SheetLayout::cell_y(std::size_t cell) const {
  return gap + static_cast<int>(cell / static_cast<std::size_t>(columns)) * (cell_height + gap);
}

SheetLayout sheet_layout(std::size_t count, int picture_width, int picture_height) {
  const double shape = static_cast<double>(picture_width) / picture_height;
  const double pictures = static_cast<double>(count);
  SheetLayout layout;
  // A column is at least a pixel and its gap.
  const double most_columns = std::min(pictures, 1.0 * most_width / (SheetLayout::gap + 1) - 1);
  layout.columns = static_cast<int>(
      std::clamp(std::ceil(std::sqrt(pictures * sheet_shape / shape)), 1.0, most_columns));
  layout.rows = static_cast<int>(std::ceil(pictures / layout.columns));
  const int room = (most_width - SheetLayout::gap) / layout.columns - SheetLayout::gap;
  const double scale = std::min({1.0, static_cast<double>(room) / picture_width,
                                 static_cast<double>(most_width) / picture_height});
  layout.cell_width = std::max(1, static_cast<int>(std::lround(scale * picture_width)));
  layout.cell_height = std::max(1, static_cast<int>(std::lround(scale * picture_height)));
  return layout;
}

std::vector<std::size_t> evenly_chosen(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t size = std::min(count, most);
  for (std::size_t i = 0; i < size; ++i) {
    chosen.push_back(size == count ? i : (i * (count - 1) + (size - 1) / 2) / (size - 1));
  }
  return chosen;
}

void write_contact_sheet(const std::filesystem::path& sheet,
                         std::span<const std::filesystem::path> pngs, int picture_width,
                         int picture_height) {
  const SheetLayout layout = sheet_layout(pngs.size(), picture_width, picture_height);
  const auto width = static_cast<std::size_t>(layout.width());
  std::vector<std::uint8_t> rgb(3 * width * static_cast<std::size_t>(layout.height()), gap_grey);
  parallel_for(pngs.size(), [&](std::size_t cell) {
    if (interrupt_requested()) throw Interrupted();
    const Image image = loaded_preview(pngs[cell], picture_width, picture_height);
    const std::size_t corner = static_cast<std::size_t>(layout.cell_y(cell)) * width +
                               static_cast<std::size_t>(layout.cell_x(cell));
    draw_cell(image, layout, rgb.data() + 3 * corner);
  });
  write_png(sheet, layout.width(), layout.height(), rgb);
}

}  // namespace restframe

#include "scene/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/parallel.h"

namespace restframe {
namespace {

constexpr int rows_at_once = 16;

// Which pixels of a row (or column) of `from` a pixel of one half as long covers, and by which
// fractions of itself: two, or three where `from` is odd.
struct Coverage {
  int first = 0, count = 1;
  std::array<float, 3> share{1, 0, 0};
};

Coverage coverage(int pixel, int from, int to) {
  if (from == to) return {pixel, 1, {1, 0, 0}};
  if (from == 2 * to) return {2 * pixel, 2, {0.5F, 0.5F, 0}};
  // from = 2 to + 1; in units of 1/to of the source's pixels, each of ours is `from` long.
  const auto whole = static_cast<float>(from);
  return {2 * pixel,
          3,
          {static_cast<float>(to - pixel) / whole, static_cast<float>(to) / whole,
           static_cast<float>(pixel + 1) / whole}};
}

// The 8 bits whose linear value is nearest: bounds[i] lies half way, as encoded, from i to i + 1.
class SrgbEncoder {
 public:
  SrgbEncoder() {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      const double encoded = (static_cast<double>(i) + 0.5) / 255;
      bounds_[i] = static_cast<float>(
          encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    for (std::size_t i = 0; i < start_.size(); ++i) {
      const float linear = static_cast<float>(i) / static_cast<float>(start_.size() - 1);
      const auto above = std::upper_bound(bounds_.begin(), bounds_.end(), linear);
      start_[i] = static_cast<std::uint8_t>(above - bounds_.begin());
    }
  }

  std::uint8_t operator()(float linear) const {
    const float scaled = std::clamp(linear, 0.0F, 1.0F) * static_cast<float>(start_.size() - 1);
    std::size_t value = start_[static_cast<std::size_t>(scaled)];
    while (value < bounds_.size() && linear > bounds_[value]) ++value;
    return static_cast<std::uint8_t>(value);
  }

 private:
  std::array<float, 255> bounds_{};
  std::array<std::uint8_t, 4096> start_{};
};

std::uint8_t data_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

Vec4f pixel_of(const TexelGrid& grid, bool srgb, int x, int y) {
  const std::uint8_t* p =
      grid.rgba + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                       static_cast<std::size_t>(x));
  return {linear_from_byte(srgb, p[0]), linear_from_byte(srgb, p[1]), linear_from_byte(srgb, p[2]),
          linear_from_byte(false, p[3])};
}

Vec4f mean(const TexelGrid& grid, const PixelMeaning& meaning, const Coverage& columns,
           const Coverage& rows) {
  Vec4f sum(0);
  Vec3f weighed(0);
  for (int j = 0; j < rows.count; ++j) {
    for (int i = 0; i < columns.count; ++i) {
      const float share =
          rows.share[static_cast<std::size_t>(j)] * columns.share[static_cast<std::size_t>(i)];
      const Vec4f pixel = pixel_of(grid, meaning.srgb, columns.first + i, rows.first + j);
      sum += share * pixel;
      weighed += share * pixel.w * Vec3f(pixel);
    }
  }
  if (!meaning.weigh_by_alpha || !(sum.w > 0)) return sum;
  return {weighed / sum.w, sum.w};
}

void shrink_row(const TexelGrid& from, const PixelMeaning& meaning, int row, int width, int height,
                std::uint8_t* to) {
  static const SrgbEncoder srgb_byte;
  const Coverage rows = coverage(row, from.height, height);
  for (int x = 0; x < width; ++x) {
    const Vec4f pixel = mean(from, meaning, coverage(x, from.width, width), rows);
    for (int c = 0; c < 3; ++c) *to++ = meaning.srgb ? srgb_byte(pixel[c]) : data_byte(pixel[c]);
    *to++ = data_byte(pixel.w);
  }
}

}  // namespace

MipChain::MipChain(const Image& image, const PixelMeaning& meaning) {
  if (image.rgba.empty()) return;
  std::size_t bytes = 0;
  for (int w = image.width, h = image.height; w > 1 || h > 1;) {
    w = std::max(1, w / 2);
    h = std::max(1, h / 2);
    copies_.push_back({w, h, bytes});
    bytes += std::size_t{4} * static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  }
  rgba_.resize(bytes);
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    const Copy& copy = copies_[i];
    const TexelGrid from = i == 0 ? grid_of(image) : level(static_cast<int>(i));
    const auto parts = static_cast<std::size_t>((copy.height + rows_at_once - 1) / rows_at_once);
    parallel_for(parts, [&](std::size_t part) {
      const int first = static_cast<int>(part) * rows_at_once;
      for (int row = first; row < std::min(copy.height, first + rows_at_once); ++row) {
        const std::size_t before =
            std::size_t{4} * static_cast<std::size_t>(row) * static_cast<std::size_t>(copy.width);
        shrink_row(from, meaning, row, copy.width, copy.height,
                   rgba_.data() + copy.offset + before);
      }
    });
  }
}

TexelGrid MipChain::level(int index) const {
  const Copy& copy = copies_[static_cast<std::size_t>(index - 1)];
  return {copy.width, copy.height, rgba_.data() + copy.offset};
}

}  // namespace restframe

#include "scene/texture.h"

#include "scene/texel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace restframe {
namespace {

// IEC 61966-2-1: from an encoded value in 0..1 to linear light.
float linear_from_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

std::array<float, 256> make_table(bool srgb) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const float value = static_cast<float>(i) / 255;
    table[i] = srgb ? linear_from_srgb(value) : value;
  }
  return table;
}

const std::array<float, 256> srgb_table = make_table(true), data_table = make_table(false);

// Into one period (two image widths where mirrored; the image itself where clamped), so that texel
// numbers stay small whatever the coordinate. A coordinate that is not finite becomes 0.
float reduce(float x, Wrap wrap) {
  if (!std::isfinite(x)) return 0;
  if (wrap == Wrap::clamp) return std::clamp(x, 0.0F, 1.0F);
  const float period = wrap == Wrap::repeat ? 1.0F : 2.0F;
  return x - period * std::floor(x / period);
}

// Into 0 to size - 1, by steps of `size`, of which it is mostly one at most: no division.
int into_period(int i, int size) {
  if (i < 0) i += size;
  if (i >= size) i -= size;
  return i >= 0 && i < size ? i : (i % size + size) % size;
}

// The texel that stands at place i of an endless row, of which i is at most one texel outside a
// period.
int wrapped(int i, int size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
  if (wrap == Wrap::repeat) return into_period(i, size);
  const int place = into_period(i, 2 * size);
  return place < size ? place : 2 * size - 1 - place;
}

// The first byte of a row.
const std::uint8_t* row_of(const TexelGrid& grid, int row) {
  return grid.rgba +
         std::size_t{4} * static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width);
}

Vec4f texel(const std::array<float, 256>& table, const std::uint8_t* row, int column) {
  const std::uint8_t* rgba = row + std::size_t{4} * static_cast<std::size_t>(column);
  return {table[rgba[0]], table[rgba[1]], table[rgba[2]], data_table[rgba[3]]};
}

}  // namespace

Vec4f sample_texture(const Texture& texture, const Image& image, const Vec2f& uv) {
  if (image.rgba.empty()) return Vec4f(1);
  return sample_grid(texture, texture.filter, grid_of(image), uv);
}

Vec4f sample_grid(const Texture& texture, TextureFilter filter, const TexelGrid& grid,
                  const Vec2f& uv) {
  const std::array<float, 256>& table = texture.srgb ? srgb_table : data_table;
  const auto column = [&](int i) { return wrapped(i, grid.width, texture.wrap_u); };
  const auto row = [&](int j) { return row_of(grid, wrapped(j, grid.height, texture.wrap_v)); };
  const float x = reduce(uv.x, texture.wrap_u) * static_cast<float>(grid.width);
  const float y = reduce(uv.y, texture.wrap_v) * static_cast<float>(grid.height);
  if (filter == TextureFilter::nearest) {
    return texel(table, row(static_cast<int>(y)), column(static_cast<int>(x)));
  }
  // Texel centres are at half-integers.
  const float left = std::floor(x - 0.5F), top = std::floor(y - 0.5F);
  const float s = x - 0.5F - left, t = y - 0.5F - top;
  const int first = column(static_cast<int>(left)), second = column(static_cast<int>(left) + 1);
  const std::uint8_t* upper = row(static_cast<int>(top));
  const std::uint8_t* lower = row(static_cast<int>(top) + 1);
  const Vec4f above = glm::mix(texel(table, upper, first), texel(table, upper, second), s);
  const Vec4f below = glm::mix(texel(table, lower, first), texel(table, lower, second), s);
  return glm::mix(above, below, t);
}

float linear_from_byte(bool srgb, std::uint8_t value) {
  return (srgb ? srgb_table : data_table)[value];
}

}  // namespace restframe

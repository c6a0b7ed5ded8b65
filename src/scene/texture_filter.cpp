#include "scene/texture_filter.h"

#include <algorithm>
#include <cmath>

namespace restframe {
namespace {

constexpr int most_samples = 8;   // along a footprint
constexpr float largest = 1e12F;  // sides, in texels: their squares' squares are floats

// The ellipse that a parallelogram's sides span, as the image of a circle; in texels.
struct Ellipse {
  float length = 0, width = 0;
  Vec2f along{1, 0};  // unit
};

// Singular values of the matrix of both sides, and the direction of the larger one.
Ellipse ellipse_of(const Vec2f& side, const Vec2f& other) {
  const float xx = side.x * side.x + other.x * other.x;
  const float yy = side.y * side.y + other.y * other.y;
  const float xy = side.x * side.y + other.x * other.y;
  const float half_difference = 0.5F * (xx - yy);
  const float root = std::sqrt(half_difference * half_difference + xy * xy);
  const float longest = 0.5F * (xx + yy) + root;
  Ellipse ellipse;
  ellipse.length = std::sqrt(longest);
  ellipse.width = std::abs(side.x * other.y - side.y * other.x) / std::max(ellipse.length, 1e-20F);
  const Vec2f along =
      half_difference > 0 ? Vec2f(half_difference + root, xy) : Vec2f(xy, root - half_difference);
  const float norm = std::sqrt(along.x * along.x + along.y * along.y);
  if (norm > 0) ellipse.along = along / norm;
  return ellipse;
}

TexelGrid level_of(const Image& image, const MipChain& mips, int level) {
  return level == 0 ? grid_of(image) : mips.level(level);
}

// level: 0 for the image itself, 1 for half its size, and so on; in between.
Vec4f sample_level(const Texture& texture, const Image& image, const MipChain& mips,
                   const Vec2f& uv, float level) {
  const int last = mips.level_count() - 1;
  const float bounded = std::clamp(level, 0.0F, static_cast<float>(last));
  const auto sample = [&](int i) {
    return sample_grid(texture, texture.shrunken_filter, level_of(image, mips, i), uv);
  };
  if (texture.mip_filter == MipFilter::nearest)
    return sample(static_cast<int>(std::lround(bounded)));
  const int below = static_cast<int>(bounded);
  const float fraction = bounded - static_cast<float>(below);
  if (fraction == 0) return sample(below);
  return glm::mix(sample(below), sample(below + 1), fraction);
}

}  // namespace

Vec4f sample_texture(const Texture& texture, const Image& image, const MipChain& mips,
                     const Vec2f& uv, const TextureFootprint& footprint) {
  const Vec2f size(image.width, image.height);
  const Vec2f side = glm::clamp(footprint.side * size, -largest, largest);
  const Vec2f other = glm::clamp(footprint.other_side * size, -largest, largest);
  const Ellipse ellipse = ellipse_of(side, other);
  const bool is_plain = image.width <= 1 && image.height <= 1;
  if (!(ellipse.length > 1) || is_plain) return sample_texture(texture, image, uv);
  if (texture.mip_filter == MipFilter::none) {
    return sample_grid(texture, texture.shrunken_filter, grid_of(image), uv);
  }
  const float ratio = std::ceil(ellipse.length / std::max(ellipse.width, 1.0F) - 0.01F);
  const int samples = ratio < most_samples ? std::max(1, static_cast<int>(ratio)) : most_samples;
  const float length = ellipse.length / static_cast<float>(samples);
  const float level = std::log2(std::max(ellipse.width, length));
  const Vec2f step = ellipse.along * length / size;
  const Vec2f first = uv - 0.5F * static_cast<float>(samples - 1) * step;
  Vec4f sum(0);
  for (int i = 0; i < samples; ++i) {
    sum += sample_level(texture, image, mips, first + static_cast<float>(i) * step, level);
  }
  return sum / static_cast<float>(samples);
}

}  // namespace restframe

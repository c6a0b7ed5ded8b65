#pragma once

#include <cstdint>

#include "scene/texture.h"

namespace restframe {

// Pixels as Image has them, of an image or of a smaller copy of it.
struct TexelGrid {
  int width = 0, height = 0;
  const std::uint8_t* rgba = nullptr;
};
inline TexelGrid grid_of(const Image& image) {
  return {image.width, image.height, image.rgba.data()};
}

// As sample_texture, with that filter.
Vec4f sample_grid(const Texture& texture, TextureFilter filter, const TexelGrid& grid,
                  const Vec2f& uv);

// From 8 bits to a linear value in 0..1.
float linear_from_byte(bool srgb, std::uint8_t value);

}  // namespace restframe

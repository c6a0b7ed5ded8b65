#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp };
enum class TextureFilter : std::uint8_t { linear, nearest };
// Between the two mipmap levels that fit best, from the better one, or none but the image itself.
enum class MipFilter : std::uint8_t { linear, nearest, none };

// Decoded pixels, 8 bits a channel, RGBA, row 0 at the top (where glTF's v = 0 is).
struct Image {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  std::string format{};  // of the file that it was read from: "PNG", "JPEG"
};

// An image as one use of it sees it. Colour textures (base colour, emission) hold sRGB, data
// linear.
struct Texture {
  int image = 0;  // index into the images of the same asset or scene
  bool srgb = true;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  TextureFilter filter = TextureFilter::linear;  // where a texel covers a pixel or more
  // Where it covers less (texture_filter.h).
  TextureFilter shrunken_filter = TextureFilter::linear;
  MipFilter mip_filter = MipFilter::linear;
};

// Linear RGBA at `uv`, u to the right and v downwards from the top left corner, as in glTF.
Vec4f sample_texture(const Texture& texture, const Image& image, const Vec2f& uv);

}  // namespace restframe

#pragma once

#include "scene/mip_chain.h"
#include "scene/texture.h"

namespace restframe {

// The part of an image that a sample stands for: a parallelogram around its point with these sides,
// in texture coordinates.
struct TextureFootprint {
  Vec2f side{0}, other_side{0};
};

// As sample_texture where the footprint is no longer than a texel. Else the mean over it, about, as
// the texture's filter for shrunken images and its mipmaps have it: where it is longer than wide,
// of some samples along it.
Vec4f sample_texture(const Texture& texture, const Image& image, const MipChain& mips,
                     const Vec2f& uv, const TextureFootprint& footprint);

}  // namespace restframe

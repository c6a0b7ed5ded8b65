#pragma once

#include <cstdint>
#include <vector>

#include "scene/texel_grid.h"

namespace restframe {

// What the pixels of an image are to averages.
struct PixelMeaning {
  bool srgb = true;  // colours of light: averaged as linear light
  // Colours count by their alpha: those that nothing is seen of leave no rims.
  bool weigh_by_alpha = false;

  bool operator==(const PixelMeaning&) const = default;
};

// Smaller and smaller copies of an image: each has half the width and height of the one before,
// rounded down, until one pixel is left. Together a third of the image's bytes.
class MipChain {
 public:
  MipChain() = default;
  // Normals need nothing special: the mean of their encodings is that of the vectors.
  MipChain(const Image& image, const PixelMeaning& meaning);

  // Level 0 is the image itself, which is not kept here.
  int level_count() const { return 1 + static_cast<int>(copies_.size()); }
  // From level 1 on.
  TexelGrid level(int index) const;
  std::size_t bytes() const { return rgba_.size(); }

 private:
  struct Copy {
    int width, height;
    std::size_t offset;
  };
  std::vector<Copy> copies_;
  std::vector<std::uint8_t> rgba_;
};

}  // namespace restframe

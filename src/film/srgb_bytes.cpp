#include "film/srgb_bytes.h"

#include <limits>

#include "scene/color.h"

namespace restframe {

SrgbBytes::SrgbBytes() {
  first_.fill(std::numeric_limits<float>::infinity());  // no byte is above 255
  for (std::size_t i = 0; i < 255; ++i) {
    first_[i] = linear_from_srgb(Vec3f((static_cast<float>(i) + 0.5F) / 255.0F)).x;
  }
  const auto first_bits = std::bit_cast<std::uint32_t>(darkest);
  std::uint8_t byte = 0;
  for (std::uint32_t i = 0; i < least_of_cell_.size(); ++i) {
    const auto least = std::bit_cast<float>(first_bits + (i << shift));
    while (least >= first_[byte]) ++byte;
    least_of_cell_[i] = byte;
  }
}

}  // namespace restframe

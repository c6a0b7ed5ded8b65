#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace restframe {

// The byte, round(255 srgb), of linear light within 0 and 1, by table: a picture asks for millions.
class SrgbBytes {
 public:
  SrgbBytes();

  // What is below 0 counts as 0, what is above 1, infinite or no number as 1.
  std::uint8_t operator()(float linear) const {
    if (linear < darkest) return 0;
    if (!(linear < 1.0F)) return 255;
    const std::uint8_t least = least_of_cell_[cell(linear)];
    return linear < first_[least] ? least : static_cast<std::uint8_t>(least + 1);
  }

 private:
  static constexpr float darkest = 0x1p-13F;  // less than half a step above black
  // 512 cells an octave: none holds more than one step.
  static constexpr int shift = 14;
  static std::size_t cell(float linear) {
    return (std::bit_cast<std::uint32_t>(linear) - std::bit_cast<std::uint32_t>(darkest)) >> shift;
  }

  std::array<float, 256> first_;  // linear light from which on a byte is above i
  std::array<std::uint8_t, std::size_t{13} << (23 - shift)> least_of_cell_;
};

}  // namespace restframe

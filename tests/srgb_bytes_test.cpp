#include "film/srgb_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace restframe {
namespace {

// IEC 61966-2-1, in bytes before they are rounded.
double srgb(double linear) {
  const double encoded =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return 255.0 * encoded;
}

TEST(SrgbBytes, AreTheNearestOnes) {
  const SrgbBytes byte_of;
  for (float linear = 1e-6F; linear < 1.1F; linear *= 1.00007F) {
    const double wanted = std::min(255.0, srgb(static_cast<double>(linear)));
    EXPECT_LE(std::abs(byte_of(linear) - wanted), 0.5 + 1e-4) << linear;
  }
}

TEST(SrgbBytes, ReachEveryByte) {
  const SrgbBytes byte_of;
  for (int byte = 0; byte < 256; ++byte) {
    const double s = byte / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    EXPECT_EQ(byte_of(static_cast<float>(linear)), byte);
  }
}

TEST(SrgbBytes, HoldWhatIsOutside) {
  const SrgbBytes byte_of;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  for (const float dark : {-infinite, -1.0F, -0.0F, 0.0F, std::numeric_limits<float>::denorm_min()})
    EXPECT_EQ(byte_of(dark), 0);
  for (const float bright :
       {1.0F, 1e30F, infinite, std::numeric_limits<float>::quiet_NaN(), std::nextafter(1.0F, 0.0F)})
    EXPECT_EQ(byte_of(bright), 255);
}

}  // namespace
}  // namespace restframe

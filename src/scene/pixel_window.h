#pragma once

#include <algorithm>

namespace restframe {

// A rectangle of pixels. (0, 0) is the display's top left pixel; what is rendered may be less than the
// display, or reach beyond it.
struct PixelWindow {
  int left = 0, top = 0;
  int width = 0, height = 0;

  int right() const { return left + width; }  // the first column after it
  int bottom() const { return top + height; }
  bool operator==(const PixelWindow&) const = default;
};

inline bool contains(const PixelWindow& window, const PixelWindow& part) {
  return part.left >= window.left && part.top >= window.top && part.right() <= window.right() &&
         part.bottom() <= window.bottom();
}

inline PixelWindow common_part(const PixelWindow& a, const PixelWindow& b) {
  const int left = std::max(a.left, b.left);
  const int top = std::max(a.top, b.top);
  return {left, top, std::max(0, std::min(a.right(), b.right()) - left),
          std::max(0, std::min(a.bottom(), b.bottom()) - top)};
}

}  // namespace restframe

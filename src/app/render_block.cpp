#include "app/render_block.h"

#include "physics/clones.h"

namespace restframe {

RESTFRAME_CLONES void place_block(const BlockPattern& pattern, int left, int top,
                                  const PixelWindow& window, PixelLanes& pixels,
                                  Lanes<std::int32_t>& active, Lanes<std::uint32_t>& place) {
  const std::uint32_t first =
      morton_place(static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top));
  const int from_x = window.left, to_x = window.right();
  const int from_y = window.top, to_y = window.bottom();
#pragma GCC ivdep
  for (int lane = 0; lane < packet_size; ++lane) {
    const std::int32_t x = left + pattern.offset.x[lane];
    const std::int32_t y = top + pattern.offset.y[lane];
    pixels.x[lane] = x;
    pixels.y[lane] = y;
    active[lane] =
        (x >= from_x ? -1 : 0) & (x < to_x ? -1 : 0) & (y >= from_y ? -1 : 0) & (y < to_y ? -1 : 0);
    place[lane] = first | pattern.place[lane];
  }
}

}  // namespace restframe

#include "app/render_block.h"

#include "physics/clones.h"

namespace restframe {

RESTFRAME_CLONES void place_block(const BlockPattern& pattern, int left, int top, int columns,
                                  int rows, PixelLanes& pixels, Lanes<std::int32_t>& active,
                                  Lanes<std::uint32_t>& place) {
  const std::uint32_t first =
      morton_place(static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top));
#pragma GCC ivdep
  for (int lane = 0; lane < packet_size; ++lane) {
    const std::int32_t across = pattern.offset.x[lane];
    const std::int32_t down = pattern.offset.y[lane];
    pixels.x[lane] = left + across;
    pixels.y[lane] = top + down;
    active[lane] = (across < columns ? -1 : 0) & (down < rows ? -1 : 0);
    place[lane] = first | pattern.place[lane];
  }
}

}  // namespace restframe

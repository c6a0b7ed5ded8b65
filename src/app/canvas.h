#pragma once

#include <vector>

#include "app/render_picture.h"
#include "film/part_file.h"

namespace restframe {

// A picture in the making, and which of its tiles are done.
struct Canvas {
  Picture picture;
  std::vector<PixelWindow> tiles;
  TileMarks done;

  explicit Canvas(const Scene& scene)
      : picture(blank_picture(scene)), tiles(picture_tiles(picture.window())), done(tiles.size()) {}

  // What a part file of it holds.
  std::vector<PartView> views() { return {{"", picture, tiles, done}}; }
};

}  // namespace restframe

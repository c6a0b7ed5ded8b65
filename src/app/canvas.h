#pragma once

#include <vector>

#include "app/render_picture.h"
#include "film/part_file.h"

namespace restframe {

// A picture in the making: what each eye sees, and which tiles of that are done.
struct Canvas {
  std::vector<Eye> eyes;
  std::vector<Picture> pictures;   // one an eye
  std::vector<PixelWindow> tiles;  // of each
  std::vector<TileMarks> done;     // likewise, one an eye

  explicit Canvas(const Scene& scene)
      : eyes(eyes_of(scene.camera)),
        pictures(blank_views(scene)),
        tiles(picture_tiles(pictures[0].window())) {
    for (std::size_t i = 0; i < eyes.size(); ++i) done.emplace_back(tiles.size());
  }

  void clear() {
    for (TileMarks& marks : done) marks.clear();
  }

  // What a part file of it holds.
  std::vector<PartView> views() {
    std::vector<PartView> parts;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
      parts.push_back({eye_name(eyes[i]), pictures[i], tiles, done[i]});
    }
    return parts;
  }
};

}  // namespace restframe

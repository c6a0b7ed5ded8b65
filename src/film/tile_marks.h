#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace restframe {

// Which tiles of a picture are done. Whoever wrote a tile's pixels marks it after the last one, so that
// whoever sees the mark sees the pixels, while other threads write other tiles.
class TileMarks {
 public:
  explicit TileMarks(std::size_t tiles) : marks_(tiles) {}

  std::size_t size() const { return marks_.size(); }
  void mark(std::size_t tile) { marks_[tile].store(true, std::memory_order_release); }
  bool is_marked(std::size_t tile) const { return marks_[tile].load(std::memory_order_acquire); }
  void clear() {
    for (std::atomic<bool>& mark : marks_) mark = false;
  }
  std::vector<std::size_t> marked() const {
    std::vector<std::size_t> tiles;
    for (std::size_t tile = 0; tile < size(); ++tile) {
      if (is_marked(tile)) tiles.push_back(tile);
    }
    return tiles;
  }

 private:
  std::vector<std::atomic<bool>> marks_;
};

}  // namespace restframe

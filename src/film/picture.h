#pragma once

#include <span>
#include <vector>

#include "film/aov.h"
#include "scene/aligned_vector.h"
#include "tracer/sample.h"

namespace restframe {

// One data channel of a picture. Times stay in double until the picture is written.
struct ChannelPixels {
  DataChannel channel;
  std::vector<float> values;  // of a plain channel
  std::vector<double> times;  // of a time
};

// One channel of what the samples of the beauty tell.
struct StatisticPixels {
  StatisticChannel channel;
  std::vector<float> values;
};

// The pixels of one picture, row by row from the top. Each pixel is written by one thread.
class Picture {
 public:
  Picture(int width, int height, std::span<const Layer> layers, const DataUnits& units);

  int width() const { return width_; }
  int height() const { return height_; }
  bool has_beauty() const { return !rgba_.empty(); }
  bool has_data() const { return !channels_.empty(); }
  // No pixel of the beauty is covered by anything.
  bool shows_nothing() const;
  const AlignedVector<Vec4f>& rgba() const { return rgba_; }
  const std::vector<ChannelPixels>& channels() const { return channels_; }
  bool has_statistics() const { return !statistics_.empty(); }
  const std::vector<StatisticPixels>& statistics() const { return statistics_; }

  // The pixels from (x, y) on to the right, which must lie in the picture.
  void set_radiance_row(int x, int y, std::span<const Vec4f> pixels) {
    if (rgba_.empty()) return;
    Vec4f* to = &rgba_[index(x, y)];
    for (const Vec4f& pixel : pixels) *to++ = pixel;
  }
  void set_radiance(int x, int y, const Vec4f& rgba) { set_radiance_row(x, y, {&rgba, 1}); }
  void set_data(int x, int y, const SurfaceData& data);
  void set_statistics(int x, int y, const SampleStatistics& statistics);

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_, height_;
  DataUnits units_;
  AlignedVector<Vec4f> rgba_;  // premultiplied; empty if the beauty is not asked for
  std::vector<ChannelPixels> channels_;
  std::vector<StatisticPixels> statistics_;
};

}  // namespace restframe

#pragma once

#include <span>
#include <string>
#include <vector>

#include "film/aov.h"
#include "film/cryptomatte.h"
#include "scene/aligned_vector.h"
#include "scene/pixel_window.h"
#include "tracer/sample.h"

namespace restframe {

// One channel of a picture besides its beauty. Times stay in double until the picture is written.
struct Plane {
  std::string name;  // in an EXR
  ChannelKind kind = ChannelKind::plain;
  std::vector<float> values;  // of a plain channel
  std::vector<double> times;  // of a time; not a number where nothing is hit
};

// The pixels of one picture, row by row from the top. Each pixel is written by one thread.
class Picture {
 public:
  Picture(const PixelWindow& window, std::span<const Layer> layers, const DataUnits& units);

  const PixelWindow& window() const { return window_; }
  int width() const { return window_.width; }
  int height() const { return window_.height; }
  // No pixel of the beauty is covered by anything.
  bool shows_nothing() const;
  bool has_beauty() const { return !rgba_.empty(); }
  bool has_data() const { return !data_.empty(); }
  bool has_statistics() const { return !statistics_.empty(); }
  const std::vector<MatteKind>& mattes() const { return mattes_; }
  const AlignedVector<Vec4f>& rgba() const { return rgba_; }
  const std::vector<Plane>& planes() const { return planes_; }

  // All pixels (x, y) must lie in the window; a row is those from (x, y) on to the right.
  void set_radiance_row(int x, int y, std::span<const Vec4f> pixels) {
    if (rgba_.empty()) return;
    Vec4f* to = &rgba_[index(x, y)];
    for (const Vec4f& pixel : pixels) *to++ = pixel;
  }
  void set_radiance(int x, int y, const Vec4f& rgba) { set_radiance_row(x, y, {&rgba, 1}); }
  void set_data(int x, int y, const SurfaceData& data);
  void set_statistics(int x, int y, const SampleStatistics& statistics);
  void set_matte(int x, int y, MatteKind kind, const MatteRanks& ranks);

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - window_.top) * static_cast<std::size_t>(window_.width) +
           static_cast<std::size_t>(x - window_.left);
  }
  void add_plane(std::string name, ChannelKind kind);

  PixelWindow window_;
  DataUnits units_;
  AlignedVector<Vec4f> rgba_;  // premultiplied; empty if the beauty is not asked for
  std::vector<DataChannel> data_;
  std::vector<StatisticChannel> statistics_;
  std::vector<MatteKind> mattes_;
  std::vector<Plane> planes_;  // of the data, then of the statistics, then of the mattes
};

}  // namespace restframe

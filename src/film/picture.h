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
  // groups: of the scene's lights, for the layers of their light.
  Picture(const PixelWindow& window, std::span<const Layer> layers, const DataUnits& units,
          std::span<const std::string> groups = {});

  const PixelWindow& window() const { return window_; }
  int width() const { return window_.width; }
  int height() const { return window_.height; }
  // No pixel of the beauty is covered by anything.
  bool shows_nothing() const;
  bool has_beauty() const { return !rgba_.empty(); }
  bool has_data() const { return !data_.empty(); }
  bool has_statistics() const { return !statistics_.empty(); }
  const std::vector<MatteKind>& mattes() const { return mattes_; }
  bool has_parts() const { return !part_columns_.empty(); }
  // Of SampleParts: what is asked for.
  std::span<const int> part_columns() const { return part_columns_; }
  const AlignedVector<Vec4f>& rgba() const { return rgba_; }
  AlignedVector<Vec4f>& rgba() { return rgba_; }
  const std::vector<Plane>& planes() const { return planes_; }
  std::vector<Plane>& planes() { return planes_; }
  // Where a pixel of the window is in these.
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - window_.top) * static_cast<std::size_t>(window_.width) +
           static_cast<std::size_t>(x - window_.left);
  }

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
  // A colour for each of part_columns().
  void set_parts(int x, int y, std::span<const Vec3f> colors);

 private:
  void add_plane(std::string name, ChannelKind kind);

  PixelWindow window_;
  DataUnits units_;
  AlignedVector<Vec4f> rgba_;  // premultiplied; empty if the beauty is not asked for
  std::vector<DataChannel> data_;
  std::vector<StatisticChannel> statistics_;
  std::vector<MatteKind> mattes_;
  std::vector<int> part_columns_;
  std::size_t first_part_ = 0;  // among the planes
  std::vector<Plane> planes_;   // of the data, the statistics, the mattes, then the parts
};

}  // namespace restframe

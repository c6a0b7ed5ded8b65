#pragma once

#include <OpenEXR/ImfPixelType.h>
#include <half.h>

#include <deque>

#include "film/exr_file.h"

namespace restframe {

// A channel as a file stores it: rows from the top, `stride` bytes from pixel to pixel.
struct StoredChannel {
  std::string name;  // without its view's
  std::string layer;
  std::size_t view = 0;
  Imf::PixelType type = Imf::FLOAT;
  const void* pixels = nullptr;
  std::size_t stride = 0;
};

// A component of the beauty as it is stored: within the range of the type, and with its precision.
float stored_light(float value, bool as_float);

// The channels of a picture in the types in which they are stored, within these types' ranges.
class StoredPicture {
 public:
  // `views` must outlive it.
  StoredPicture(std::span<const Picture> views, const PictureInfo& info);

  const std::vector<StoredChannel>& channels() const { return channels_; }
  // Taken off time_proper and time_world, in seconds; the same for all views.
  const std::pair<double, double>& time_origins() const { return time_origins_; }
  const WriteReport& report() const { return report_; }

 private:
  void add_beauty(const Picture& picture, std::size_t view, bool as_float);
  void add_plane(const Plane& plane, StoredChannel channel, bool as_half);

  std::pair<double, double> time_origins_;
  std::vector<StoredChannel> channels_;
  WriteReport report_;
  // What is not stored as it is. Additions leave the others where they are.
  std::deque<std::vector<half>> halves_;
  std::deque<std::vector<float>> floats_;
};

}  // namespace restframe

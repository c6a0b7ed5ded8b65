#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "film/picture.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace restframe {

// One of several that a picture has, by OpenEXR's name for it: "left", "right".
struct ViewInfo {
  std::string name;
  CameraPose pose;
};

// What the header of a picture says besides its pixels.
struct PictureInfo {
  int number = 0;
  double camera_time = 0;  // the camera's own clock when the shutter opens
  CameraPose pose;
  std::vector<ViewInfo> views;  // the default one first; empty: there is one, at `pose`
  PixelWindow display;    // what the camera's field of view fills; empty: the picture's window
  PixelWindow uncropped;  // the window that the picture is cut out of; empty: it is whole
  double light_speed = 1;
  double rate = 10;                      // pictures a second
  double shutter = 0;                    // seconds that it is open
  std::optional<double> focus;           // light-seconds; nothing: all is sharp
  bool float_beauty = false;             // else half
  std::vector<std::string> half_layers;  // others besides the beauty are float
  std::string only_layer;                // empty: all
  Compression compression = Compression::zip;
  double compression_level = 45;  // of DWAA and DWAB
  std::vector<std::string> object_names, material_names;
  // Further attributes as text: program version, canonical settings and their hash, assets' hashes
  // ...
  std::vector<std::pair<std::string, std::string>> texts;
};

// What had to be changed to fit a picture's pixels into the file.
struct WriteReport {
  std::size_t clamped = 0;       // beauty values that overflow or are not finite
  std::size_t clamped_data = 0;  // finite values of other layers that overflow

  WriteReport& operator+=(const WriteReport& other) {
    clamped += other.clamped;
    clamped_data += other.clamped_data;
    return *this;
  }
};

// Writes beside, closes, checks, renames: nothing partial ever has the final name. One picture for each
// view. Throws OutputError.
//
// A compression that loses precision is for layers that are only looked at: others would lose edges, names
// and moments. Where a picture has both, the file has two parts, "light" and "data", and the second is
// compressed as by `zip`; of several views, each has both.
WriteReport write_exr(const std::filesystem::path& path, std::span<const Picture> views,
                      const PictureInfo& info);
inline WriteReport write_exr(const std::filesystem::path& path, const Picture& picture,
                             const PictureInfo& info) {
  return write_exr(path, {&picture, 1}, info);
}

}  // namespace restframe

#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "film/picture.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace restframe {

// What the header of a picture says besides its pixels.
struct PictureInfo {
  int number = 0;
  double camera_time = 0;  // the camera's own clock when the shutter opens
  CameraPose pose;
  PixelWindow display;  // what the camera's field of view fills; empty: the picture's window
  double light_speed = 1;
  double rate = 10;           // pictures a second
  bool float_beauty = false;  // else half
  Compression compression = Compression::zip;
  std::vector<std::string> object_names, material_names;
  // Further attributes as text: program version, canonical settings and their hash, assets' hashes
  // ...
  std::vector<std::pair<std::string, std::string>> texts;
};

// What had to be changed to fit a picture's pixels into the file.
struct WriteReport {
  std::size_t clamped = 0;  // beauty values that overflow or are not finite
};

// Writes beside, closes, checks, renames: nothing partial ever has the final name. Throws
// OutputError.
WriteReport write_exr(const std::filesystem::path& path, const Picture& picture,
                      const PictureInfo& info);

// The text attribute `name` of a complete EXR; empty where the file is missing, torn, or has none.
std::string exr_text(const std::filesystem::path& path, const std::string& name);

}  // namespace restframe

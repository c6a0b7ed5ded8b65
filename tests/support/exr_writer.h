#pragma once

// OpenEXR files, made in memory by tests.

#include <functional>
#include <string>
#include <vector>

#include "physics/vectors.h"
#include "scene/settings.h"

namespace restframe {

struct ExrText {
  int width = 0, height = 0;
  std::vector<std::pair<std::string, std::vector<float>>> channels;  // row by row from the top
  Compression compression = Compression::zip;
  bool half = false;      // else float
  int left = 0, top = 0;  // of the data window; the display window begins at 0
};

// The file's bytes.
std::string exr_bytes(const ExrText& exr);

// A latitude-longitude picture of R, G and B in 32-bit floats, pixel by pixel.
std::string sky_exr(int width, int height, const std::function<Vec3f(int x, int y)>& radiance,
                    Compression compression = Compression::zip);

}  // namespace restframe

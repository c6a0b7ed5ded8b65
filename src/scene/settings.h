#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace restframe {

struct AnimationSettings {
  double rate = 10;  // pictures a second of the camera's own time
  double start = 0;
  int pictures = 1;
};

struct RenderSettings {
  int width = 1280, height = 720;
  int samples = 16;
  bool beaming = false;
  std::uint64_t seed = 0;
};

// Layers of an EXR by the names of the scene file (design, section 7).
enum class Layer : std::uint8_t { beauty, z, time, doppler, normal, position, uv, id };

enum class Compression : std::uint8_t { none, rle, zips, zip, piz, pxr24, dwaa, dwab };

struct OutputSettings {
  std::string path = "out/picture.####.exr";  // # stand for digits of the picture number
  std::vector<Layer> layers = {Layer::beauty, Layer::z};
  Compression compression = Compression::zip;
  bool preview = true;  // a PNG beside each EXR
};

}  // namespace restframe

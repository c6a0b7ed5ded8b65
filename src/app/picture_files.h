#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "film/exr_file.h"
#include "scene/scene.h"

namespace restframe {

// "out/name.####.exr" and 7 give "out/name.0007.exr". Throws InputError where the pattern does not serve
// (see output_pattern_fault).
std::filesystem::path picture_path(const std::string& pattern, int number, bool single);

// A file of a picture: of all its layers, or of one.
struct LayerFile {
  std::string layer;  // empty: all
  std::filesystem::path path;
};

// In the order in which they are written: a picture is there when all of its images are.
struct PictureFiles {
  std::filesystem::path
      whole;  // that would hold all layers: parts of the picture are called after it
  std::filesystem::path preview;
  std::vector<LayerFile> images;
};
PictureFiles picture_files(const Scene& scene, int number, bool single);

// "out/name.####.exr" and "Z" give "out/name.Z.####.exr": before the number, with the separator that
// stands there; or before the extension.
std::string layer_pattern(const std::string& pattern, const std::string& layer);

// All bytes of a file. Throws InputError where it can not be read.
std::string file_content(const std::filesystem::path& path);

// What the header says: of all pictures of a scene, and of one.
PictureInfo common_info(const Scene& scene);
PictureInfo picture_info(PictureInfo common, const Scene& scene, int number);

}  // namespace restframe

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "film/exr_file.h"
#include "scene/scene.h"

namespace restframe {

// "out/name.####.exr" and 7 give "out/name.0007.exr". Throws InputError where the pattern does not serve
// (see output_pattern_fault).
std::filesystem::path picture_path(const std::string& pattern, int number, bool single);

// All bytes of a file. Throws InputError where it can not be read.
std::string file_content(const std::filesystem::path& path);

// Of the pictures [first, last], those that are still to be made: missing or torn ones. A complete
// picture of another scene is an InputError that says what differs; `overwrite` makes all again.
std::vector<int> pictures_to_make(const Scene& scene, int first, int last, bool overwrite);

enum class Found : std::uint8_t { nothing_of_use, the_same, another };

struct ExistingPicture {
  Found found = Found::nothing_of_use;
  std::string difference;  // of another scene's
};

// What is there under the names of the pictures [first, last].
std::vector<ExistingPicture> existing_pictures(const Scene& scene, int first, int last);

// What the header says: of all pictures of a scene, and of one.
PictureInfo common_info(const Scene& scene);
PictureInfo picture_info(PictureInfo common, const Scene& scene, int number);

}  // namespace restframe

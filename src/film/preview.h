#pragma once

#include <filesystem>
#include <string>

#include "film/picture.h"
#include "film/view_transform.h"

namespace restframe {

// How a picture's beauty becomes the PNG beside it, over black, in sRGB.
struct PreviewInfo {
  Development development;
  bool float_beauty = false;  // the EXR stores it as float, else as half
  std::string label;          // of the PNG: what it shows, and how
};

// Of the beauty as an EXR stores it, so that both give the same bytes, unless the EXR's compression loses
// precision. Throws OutputError.
void write_preview(const std::filesystem::path& png, const Picture& picture,
                   const PreviewInfo& info);

// Of the beauty, its first view, that an EXR holds. Throws OutputError also where it can not be read.
void write_preview(const std::filesystem::path& png, const std::filesystem::path& exr,
                   const PreviewInfo& info);

}  // namespace restframe

#pragma once

#include <OpenEXR/ImfHeader.h>

#include "film/exr_file.h"

namespace restframe {

// The header of a picture, or of one part of it, without its channels and info.texts.
// `pose`: of what it shows. time_origins: of time_proper and time_world, in seconds.
Imf::Header exr_header(const PixelWindow& window, const PictureInfo& info, const CameraPose& pose,
                       const std::pair<double, double>& time_origins);

void set_compression(Imf::Header& header, Compression compression, double level);

// The views of a header that has them all, and where the others than the default one stand.
void add_views(Imf::Header& header, const PixelWindow& window, const PictureInfo& info);

}  // namespace restframe

#pragma once

#include <OpenEXR/ImfHeader.h>

#include "film/exr_file.h"

namespace restframe {

// The header of a picture, without its channels. time_origins: of time_proper and time_world, in
// seconds.
Imf::Header exr_header(const Picture& picture, const PictureInfo& info,
                       const std::pair<double, double>& time_origins);

}  // namespace restframe

#pragma once

#include <nlohmann/json.hpp>

#include "app/asset_report.h"
#include "frames/frame_set.h"

namespace restframe {

// What info's text says of a scene: rest frames with their objects, lights, materials, memory.
nlohmann::ordered_json json_of(const Scene& scene, const FrameSet& frames,
                               const std::vector<char>& closed);

// Everything on one page, for programs: names that are no UTF-8 get replacement characters.
std::string document_text(const nlohmann::ordered_json& document);

}  // namespace restframe

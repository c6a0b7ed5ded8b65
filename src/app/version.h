#pragma once

namespace restframe {

inline constexpr const char* program_version = RESTFRAME_VERSION;

}  // namespace restframe

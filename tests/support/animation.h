#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/exr_reader.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {

// All pictures that the program makes of a scene file. Throws std::runtime_error with the program's
// words if it fails.
inline std::vector<ExrPicture> rendered_animation(const std::filesystem::path& program,
                                                  const std::string& scene_file, int pictures) {
  const TemporaryFolder folder;
  const auto scene = folder.write("scene.toml", scene_file);
  const auto pattern = folder.path() / "picture.####.exr";
  const RunResult result =
      run_program(program, {"render", scene.string(), "--output", pattern.string(), "--quiet"});
  if (result.exit_code != 0) {
    throw std::runtime_error(fmt::format("exit code {}: {}", result.exit_code, result.error));
  }
  std::vector<ExrPicture> all;
  for (int i = 0; i < pictures; ++i) {
    all.push_back(read_exr(folder.path() / fmt::format("picture.{:04}.exr", i)));
  }
  return all;
}

}  // namespace restframe

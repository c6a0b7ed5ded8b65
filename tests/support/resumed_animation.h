#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/scene_folder.h"

namespace restframe {

inline constexpr const char* kResumedScene = R"(
[animation]
rate = 25
pictures = 4
[render]
resolution = [40, 30]
samples = 2
[output]
path = "p.#.exr"
layers = ["beauty", "time"]
[[object]]
asset = "square.obj"
velocity = [0.5, 0, 0]
)";

inline constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

// A small animation that is rendered several times.
class ResumedAnimation : public testing::Test, public SceneFolder {
 protected:
  ResumedAnimation() : SceneFolder(kResumedScene) { write("square.obj", kSquare); }

  void make(const std::vector<std::string>& options = {}) const {
    const RunResult result = render(options);
    ASSERT_EQ(result.exit_code, 0) << result.error;
  }
};

}  // namespace restframe

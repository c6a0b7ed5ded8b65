#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/temporary_folder.h"

namespace restframe {

// Scenes from text, in a folder that has the asset paint.obj, a triangle of one material "paint".
class SceneReading : public ::testing::Test {
 protected:
  SceneReading() {
    folder.write("paint.obj",
                 "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n");
    folder.write("paint.mtl", "newmtl paint\nKd 1 1 1\n");
  }

  Scene read(const std::string& text) {
    return load_scene(folder.write("scene.toml", text), {}, warnings);
  }

  // The faults of a scene; "scene.toml:" is left off where a line begins with it.
  std::vector<std::string> faults(const std::string& text) {
    const std::string file = (folder.path() / "scene.toml").string() + ":";
    try {
      read(text);
    } catch (const InputError& error) {
      std::vector<std::string> lines = error.faults();
      for (std::string& line : lines) {
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        if (line.starts_with(file)) line.erase(0, file.size());
      }
      return lines;
    }
    return {};
  }

  TemporaryFolder folder;
  Warnings warnings;
};

}  // namespace restframe

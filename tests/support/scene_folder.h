#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "support/file_bytes.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {

// A folder with scene.toml, and the program run there on it.
class SceneFolder {
 public:
  explicit SceneFolder(std::string scene) : scene_(std::move(scene)) {
    write("scene.toml", scene_);
  }

  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  std::string content(const std::string& name) const { return bytes_of(path(name)); }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  // The scene as it was at first, but for this.
  void change_scene(const std::string& before, const std::string& after) const {
    std::string text = scene_;
    write("scene.toml", text.replace(text.find(before), before.size(), after));
  }

  RunResult run(const std::string& command, const std::vector<std::string>& more = {},
                RunOptions options = {}) const {
    std::vector<std::string> arguments = {command, "scene.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    options.folder = folder_.path();
    return run_program(RESTFRAME_PROGRAM, arguments, options);
  }
  RunResult render(const std::vector<std::string>& more = {},
                   const RunOptions& options = {}) const {
    return run("render", more, options);
  }

 private:
  std::string scene_;
  TemporaryFolder folder_;
};

}  // namespace restframe

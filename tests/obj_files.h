#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

namespace restframe {

// A folder of its own for one test's files, removed with them.
class ObjFiles {
 public:
  ObjFiles() {
    static std::atomic<int> count{0};
    const std::string name =
        "restframe_obj_" + std::to_string(getpid()) + "_" + std::to_string(count++);
    folder_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(folder_);
  }
  ~ObjFiles() { std::filesystem::remove_all(folder_); }
  ObjFiles(const ObjFiles&) = delete;
  ObjFiles& operator=(const ObjFiles&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace restframe

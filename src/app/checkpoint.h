#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

#include "film/part_file.h"

namespace restframe {

// Keeps what is done of a picture in a part file, every so many seconds while it exists, on a thread of
// its own. That fails with a warning: the picture may get on without.
class Checkpoints {
 public:
  // The views must outlive it. interval: 0: none.
  Checkpoints(std::filesystem::path path, PartInfo info, std::vector<PartView> views,
              std::chrono::duration<double> interval);
  ~Checkpoints();  // drops what is being written
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;

 private:
  void work(std::chrono::duration<double> interval);
  void write();

  std::filesystem::path path_;
  PartInfo info_;
  std::vector<PartView> views_;
  bool warned_ = false;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread thread_;
};

}  // namespace restframe

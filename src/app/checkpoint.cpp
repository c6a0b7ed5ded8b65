#include "app/checkpoint.h"

#include "app/messages.h"

namespace restframe {

Checkpoints::Checkpoints(std::filesystem::path path, PartInfo info, std::vector<PartView> views,
                         std::chrono::duration<double> interval)
    : path_(std::move(path)), info_(std::move(info)), views_(std::move(views)) {
  if (interval.count() > 0) thread_ = std::thread([this, interval] { work(interval); });
}

Checkpoints::~Checkpoints() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Checkpoints::work(std::chrono::duration<double> interval) {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, interval, [this] { return stop_.load(); })) {
    lock.unlock();
    write();
    lock.lock();
  }
}

void Checkpoints::write() {
  try {
    write_part(path_, info_, views_, stop_);
  } catch (const std::exception& error) {  // out of memory, too: the picture matters more
    if (!std::exchange(warned_, true)) {
      report_warning(std::string("no checkpoint: ") + error.what());
    }
  }
}

}  // namespace restframe

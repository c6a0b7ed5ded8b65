#include "scene/temporary_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <set>
#include <string>

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr const char* name_start = ".restframe-";
constexpr const char* name_end = ".tmp";

struct Registry {
  std::mutex mutex;
  std::set<fs::path> files;
};

// Never destroyed: other threads may still be at work when the program ends.
Registry& registry() {
  static auto* const all = new Registry;
  return *all;
}

// So much of this machine's name as a file name can hold.
std::string host_tag() {
  std::array<char, 65> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
  std::string tag = name.data();
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  std::replace_if(
      tag.begin(), tag.end(), [&](char c) { return !is_plain(c); }, '_');
  return tag.substr(0, 32);
}

// False where somebody took it for an orphan between its making and its locking. Where there are no
// locks, nobody takes anything for an orphan.
bool lock_new_file(int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

bool is_orphan(int descriptor, bool made_here) {
  constexpr std::time_t long_ago = 3600;  // seconds
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return false;
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return false;
  return made_here || std::time(nullptr) - status.st_mtime > long_ago;
}

}  // namespace

TemporaryFile create_temporary(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  constexpr int attempts = 1000;  // another machine may have this one's name and process number
  const std::string start = name_start + host_tag() + "-" + std::to_string(::getpid()) + "-";
  const std::scoped_lock lock(registry().mutex);
  for (int i = 0; i < attempts; ++i) {
    fs::path path = folder / (start + std::to_string(counter++) + name_end);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 && lock_new_file(descriptor)) {
      registry().files.insert(path);
      return {std::move(path), descriptor};
    }
    if (descriptor >= 0) {
      ::unlink(path.c_str());
      ::close(descriptor);
    } else if (errno != EEXIST && errno != EINTR) {
      return {};
    }
  }
  errno = EEXIST;
  return {};
}

bool publish_temporary(const fs::path& temporary, const fs::path& path) {
  const std::scoped_lock lock(registry().mutex);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) return false;
  registry().files.erase(temporary);
  return true;
}

void remove_temporary(const fs::path& temporary) {
  const std::scoped_lock lock(registry().mutex);
  ::unlink(temporary.c_str());
  registry().files.erase(temporary);
}

void abandon_temporaries() {
  registry().mutex.lock();
  for (const fs::path& file : registry().files) ::unlink(file.c_str());
}

void remove_orphans(const fs::path& folder) {
  const std::string ours = name_start + host_tag() + "-";
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(name_start) || !name.ends_with(name_end)) continue;
    const int flags = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    const int descriptor = ::open(entry->path().c_str(), flags);
    if (descriptor < 0) continue;
    if (is_orphan(descriptor, name.starts_with(ours))) ::unlink(entry->path().c_str());
    ::close(descriptor);
  }
}

}  // namespace restframe

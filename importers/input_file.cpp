#include "importers/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

std::string unreadable(const std::error_code& error) {
  return "can not be read: " + error.message();
}

std::string unreadable() {
  return unreadable({errno, std::generic_category()});
}

// Devices are not even opened: some act on it.
std::optional<std::string> kind_fault(const fs::path& path) {
  std::error_code error;
  switch (fs::status(path, error).type()) {
    case fs::file_type::regular:
      return std::nullopt;
    case fs::file_type::not_found:
      return "no such file";
    case fs::file_type::directory:
      return "is a folder, not a regular file";
    case fs::file_type::none:
      return unreadable(error);
    default:
      return "is not a regular file";
  }
}

int open_to_read(const fs::path& path) {
  return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
}

}  // namespace

InputFile::InputFile(const fs::path& path, std::string at) : at_(std::move(at)) {
  if (const auto fault = kind_fault(path)) fail(*fault);
  descriptor_ = open_to_read(path);
  if (descriptor_ < 0) fail(unreadable());
  // The path may have come to name something else since.
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    fail("is not a regular file");
  }
  size_ = static_cast<std::size_t>(status.st_size);
}

InputFile::~InputFile() {
  ::close(descriptor_);
}

void InputFile::check_size(std::size_t limit) const {
  if (size_ > limit) fail(fmt::format("file of {} bytes, the limit is {} bytes", size_, limit));
}

void InputFile::read(void* bytes, std::size_t count) {
  auto* target = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = ::read(descriptor_, target, std::min(count, std::size_t{1} << 30));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(unreadable());
    if (got == 0) fail("the file ends early");
    target += got;
    count -= static_cast<std::size_t>(got);
  }
}

void InputFile::fail(const std::string& reason) const {
  throw InputError(on_one_line(at_ + ": " + reason));
}

std::optional<std::string> input_file_fault(const fs::path& path) {
  if (auto fault = kind_fault(path)) return fault;
  const int descriptor = open_to_read(path);
  if (descriptor < 0) return unreadable();
  ::close(descriptor);
  return std::nullopt;
}

}  // namespace restframe

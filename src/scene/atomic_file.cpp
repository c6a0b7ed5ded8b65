#include "scene/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/temporary_files.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t buffer_size = 1 << 16;

[[noreturn]] void fail_with(const fs::path& path, const std::string& reason) {
  throw OutputError(path.string() + ": can not be written: " + reason);
}

// Where the bytes go in the end, behind symbolic links.
fs::path target_of(const fs::path& path) {
  if (path.filename().empty()) fail_with(path, "the path names no file");
  if (path.native().find('\0') != std::string::npos) fail_with(path.c_str(), "NUL in the path");
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;  // a link to nothing is itself replaced
}

// A device or a folder must not be replaced by a file.
void check_replaceable(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type != fs::file_type::not_found && type != fs::file_type::regular &&
      type != fs::file_type::symlink) {
    fail_with(path, error ? error.message() : "it is not a regular file");
  }
}

void create_folders(const fs::path& path) {
  std::error_code error;
  fs::create_directories(folder_of(path), error);
  if (error) fail_with(path, error.message());
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(target_of(path)) {
  check_replaceable(path_);
  create_folders(path_);
  buffer_.reserve(buffer_size);
  TemporaryFile file = create_temporary(folder_of(path_));
  if (file.descriptor < 0) fail(errno);
  temporary_ = std::move(file.path);
  descriptor_ = file.descriptor;
}

AtomicFile::~AtomicFile() {
  // Nobody is left to tell if these fail, and nothing under the final name depends on them.
  if (!temporary_.empty()) remove_temporary(temporary_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  if (buffer_.size() + bytes.size() > buffer_size) {
    write_through(buffer_);
    buffer_.clear();
  }
  if (bytes.size() > buffer_size) {
    write_through(bytes);
  } else {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  }
}

void AtomicFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text)));
}

void AtomicFile::write_through(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written == 0) fail(EIO);
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  write_through(buffer_);
  buffer_.clear();
  if (::fsync(descriptor_) != 0) fail(errno);
  const int closing = descriptor_;
  descriptor_ = ::fcntl(closing, F_DUPFD_CLOEXEC, 0);  // keeps the lock until the file has its name
  const int lock_error = descriptor_ < 0 ? errno : 0;
  if (::close(closing) != 0) fail(errno);  // it is closed even then
  if (lock_error != 0) fail(lock_error);
  if (!publish_temporary(temporary_, path_)) fail(errno);
  temporary_.clear();
}

void AtomicFile::fail(int error_number) const {
  fail_with(path_, std::generic_category().message(error_number));
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

void write_file_atomically(const fs::path& path, const std::function<void(AtomicFile&)>& produce) {
  AtomicFile file(path);
  produce(file);
  file.commit();
}

}  // namespace restframe

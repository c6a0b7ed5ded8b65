#pragma once

// The one way to files on disk. Only regular files are read: a FIFO would hang, a device never end.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace restframe {

// An open file. Opening never blocks, whatever the path names.
class InputFile {
 public:
  // Throws InputError where there is no regular file that can be read. `at` is put before the
  // reason of this and all later faults: the path, or where it is named.
  InputFile(const std::filesystem::path& path, std::string at);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::size_t size() const { return size_; }
  // Throws InputError where the file holds more than `limit` bytes.
  void check_size(std::size_t limit) const;
  // The next bytes of the file. Throws InputError if it ends before.
  void read(void* bytes, std::size_t count);

 private:
  [[noreturn]] void fail(const std::string& reason) const;

  std::string at_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

// Why `path` can not be read as a file ("no such file"), or nothing if it can.
std::optional<std::string> input_file_fault(const std::filesystem::path& path);

// The whole file, as text or as a vector of bytes. Throws InputError, `at` before the reason, where
// it can not be read or holds more than `limit` bytes.
template <class Bytes = std::string>
Bytes read_input_file(const std::filesystem::path& path, std::size_t limit, const std::string& at) {
  InputFile file(path, at);
  file.check_size(limit);
  Bytes bytes(file.size(), typename Bytes::value_type{});
  file.read(bytes.data(), bytes.size());
  return bytes;
}

}  // namespace restframe

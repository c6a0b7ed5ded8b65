#pragma once

// Files that are there whole or not at all: written beside under a name of their own, closed,
// checked, then renamed. Any number of processes may write the same file: the last one's is there.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace restframe {

// A new file, in the making until commit(). Every function throws OutputError with the path and the
// system's reason.
class AtomicFile {
 public:
  // Creates missing parent folders. A symbolic link is followed: what it points to is replaced.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();  // without commit(): as if there had been nothing

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  // Where the bytes are until then: for another program that writes them.
  const std::filesystem::path& temporary_path() const { return temporary_; }

  // Everything is on the disk, under the final name, when it returns.
  void commit();

 private:
  void write_through(std::span<const std::byte> bytes);
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_, temporary_;
  std::vector<std::byte> buffer_;
  int descriptor_ = -1;
};

void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

// Commits after `produce` returned; keeps nothing if it throws.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(AtomicFile&)>& produce);

}  // namespace restframe

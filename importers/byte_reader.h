#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "importers/input_file.h"

namespace restframe {

// A binary file, read from front to back through a buffer of its own.
class ByteReader {
 public:
  // Throws InputError where the file can not be read or holds more than `limit` bytes.
  ByteReader(const std::filesystem::path& path, std::size_t limit);

  std::size_t size() const { return file_.size(); }
  std::size_t offset() const { return offset_; }
  std::size_t left() const { return file_.size() - offset_; }

  // The next bytes, which stay the next: at most 64 KiB of them, fewer where the file ends.
  std::string_view peek(std::size_t count);
  void skip(std::size_t count);

  // An integer or floating-point number as the file has it. Throws InputError where the file ends.
  template <class Number>
  Number read(std::endian order) {
    std::array<char, sizeof(Number)> bytes{};
    const std::string_view next = peek(sizeof(Number));
    if (next.size() < sizeof(Number)) fail("the file ends early");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = next[order == std::endian::native ? i : bytes.size() - 1 - i];
    }
    offset_ += bytes.size();
    Number number;
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
  }

  // Throws InputError: "FILE: byte N: reason", N being the offset of the next byte.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  std::string name_;
  InputFile file_;
  std::vector<char> buffer_;
  std::size_t buffer_begin_ = 0;  // offset in the file of the buffer's first byte
  std::size_t offset_ = 0;        // of the next byte
};

}  // namespace restframe

#pragma once

#include <string>

#include "importers/byte_reader.h"
#include "importers/ply_header.h"
#include "importers/text_words.h"

namespace restframe {

// The numbers that follow a PLY file's header, one by one, as text or bytes. Both throw InputError,
// with the place, where there is no number of the type that is asked for.

class PlyText {
 public:
  // The file's lines after the header, of so many bytes.
  PlyText(TextFile& file, std::size_t header_bytes);

  // Whole for integer types, and in their range; of floating point, it may be NaN or infinite.
  double next(PlyType type);
  void skip(PlyType type, std::uint64_t count);
  bool at_end() { return words_.next().empty(); }

  // Throws InputError at the last number.
  [[noreturn]] void fail(const std::string& reason) const { words_.fail(word_, reason); }

 private:
  TextWords words_;
  std::string_view word_;
};

class PlyBytes {
 public:
  // The file's bytes after the header.
  PlyBytes(ByteReader& file, std::endian order) : file_(file), order_(order) {}

  double next(PlyType type);
  void skip(PlyType type, std::uint64_t count);
  bool at_end() const { return file_.left() == 0; }
  [[noreturn]] void fail(const std::string& reason) const { file_.fail(reason); }

 private:
  ByteReader& file_;
  std::endian order_;
};

}  // namespace restframe

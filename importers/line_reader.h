#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "importers/input_file.h"

namespace restframe {

// The lines of a text file, read a block at a time: however long the file, it takes the memory of
// its longest line. Lines end with LF, CRLF or CR.
class LineReader {
 public:
  // Where in the file; both count from 1.
  struct Place {
    std::uint64_t line = 0, column = 0;
  };

  // Throws InputError if the file can not be read, is larger than `limit` bytes or is UTF-16. A
  // byte order mark of UTF-8 is blanked.
  LineReader(std::filesystem::path path, std::size_t limit);

  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return file_.size(); }  // of the file, in bytes

  // The next line without its end, valid until the next call; false if there is none. A backslash
  // at a line's end joins the next line to it, and is blanked. Throws InputError at a NUL byte.
  bool next_line(std::string_view& line);

  // Of a part of the line that next_line gave last.
  Place place(std::string_view word) const;
  std::string position(Place place) const;  // FILE:LINE:COLUMN

  // Throws InputError: `reason` at `word`, which is part of the last line.
  [[noreturn]] void fail(std::string_view word, const std::string& reason) const;
  [[noreturn]] void fail(Place place, const std::string& reason) const;

 private:
  void check_encoding();
  bool read_on();
  bool next_physical_line(std::string_view& line);
  std::size_t line_length();

  std::filesystem::path path_;
  InputFile file_;
  std::size_t unread_ = 0;    // bytes of the file that are not in the buffer yet
  std::vector<char> buffer_;  // holds text from next_ to end_
  std::size_t next_ = 0, end_ = 0;
  bool after_cr_ = false, has_cr_ = false, has_nul_ = false;
  std::uint64_t lines_ = 0;  // so far, joined ones counted singly
  std::string joined_;
  std::vector<std::size_t> joints_;  // where in joined_ its second and further lines begin
  std::string_view line_;
};

}  // namespace restframe

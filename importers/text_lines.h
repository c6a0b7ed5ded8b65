#pragma once

// Text files by lines and words, with positions for errors.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace restframe {

// A text file in memory. Lines end with LF, CRLF or CR.
class TextFile {
 public:
  // Throws InputError if it can not be read, is larger than `limit` bytes, is UTF-16 or contains
  // NUL. A byte order mark of UTF-8 is blanked.
  TextFile(std::filesystem::path path, std::size_t limit);

  const std::filesystem::path& path() const { return path_; }
  std::string_view text() const { return bytes_; }

  // The next line without its end, or false if there is none. A backslash at a line's end joins the
  // next line to it; the joint is blanked in `line`, so that offsets into it stay offsets into the
  // text.
  bool next_line(std::string_view& line);

  // FILE:LINE:COLUMN of `word`, which is part of the line that next_line gave last.
  std::string position(std::string_view word) const { return position(offset(word)); }
  std::string position(std::size_t offset) const;
  std::size_t offset(std::string_view word) const;

  // Throws InputError: `reason` at `word`.
  [[noreturn]] void fail(std::string_view word, const std::string& reason) const;
  [[noreturn]] void fail(std::size_t offset, const std::string& reason) const;

 private:
  void check_encoding();
  std::size_t line_end(std::size_t begin);
  std::size_t skip_line_end(std::size_t end) const;
  std::string_view join_lines(std::size_t end);

  // Where an offset is; lines are counted on from here.
  struct Location {
    std::size_t offset = 0, line = 1, line_begin = 0;
  };

  std::filesystem::path path_;
  std::string bytes_;
  std::string joined_;
  std::size_t line_begin_ = 0, next_begin_ = 0, next_lf_ = 0;
  mutable Location located_;
};

inline bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// The first word of `rest` (spaces and tabs divide), taken off it; empty if there is none.
inline std::string_view take_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

// Without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

// A decimal number that makes up the whole word; numbers too small for a double are 0. False: it is
// none, or is too large for a double, infinite or NaN.
bool read_number(std::string_view word, double& value);

// Why read_number refused `word`, in words.
std::string number_fault(std::string_view word);

}  // namespace restframe

#include "importers/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "importers/input_file.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::string_view blanks = " \t";

// An exponent that no number that is meant has; 0e500 among them.
bool has_huge_exponent(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  if (e == word.npos) return false;
  word.remove_prefix(std::min(e + (word.substr(e + 1, 1) == "+" ? 2 : 1), word.size()));
  int exponent = 0;
  const auto error = std::from_chars(word.data(), word.data() + word.size(), exponent).ec;
  return word.substr(0, 1) != "-" && (exponent > 400 || error == std::errc::result_out_of_range);
}

}  // namespace

TextFile::TextFile(std::filesystem::path path, std::size_t limit)
    : path_(std::move(path)), bytes_(read_input_file(path_, limit, path_.string())) {
  check_encoding();
}

void TextFile::check_encoding() {
  const std::string_view text = bytes_;
  const std::string_view start = text.substr(0, 2);
  const bool zeros = text.size() > 3 && ((!text[0] && text[1] && !text[2] && text[3]) ||
                                         (text[0] && !text[1] && text[2] && !text[3]));
  if (start == "\xFF\xFE" || start == "\xFE\xFF" || zeros) {
    fail(std::size_t{0}, "the text is UTF-16, must be UTF-8 or ASCII: save or convert it as UTF-8");
  }
  const std::size_t nul = text.find('\0');
  if (nul != text.npos) fail(nul, "a NUL byte: this is not a text file");
  if (text.substr(0, 3) == "\xEF\xBB\xBF") bytes_.replace(0, 3, 3, ' ');
}

// The next LF is kept: a file of CR alone would be searched to its end for every line.
std::size_t TextFile::line_end(std::size_t begin) {
  if (next_lf_ < begin || begin == 0) next_lf_ = std::min(bytes_.find('\n', begin), bytes_.size());
  const void* cr = std::memchr(bytes_.data() + begin, '\r', next_lf_ - begin);
  return cr ? static_cast<std::size_t>(static_cast<const char*>(cr) - bytes_.data()) : next_lf_;
}

std::size_t TextFile::skip_line_end(std::size_t end) const {
  const bool crlf = std::string_view(bytes_).substr(end, 2) == "\r\n";
  return std::min(end + (crlf ? 2 : 1), bytes_.size());
}

std::string_view TextFile::join_lines(std::size_t end) {
  joined_.assign(bytes_, line_begin_, end - line_begin_);
  while (!joined_.empty() && joined_.back() == '\\' && end < bytes_.size()) {
    joined_.back() = ' ';
    const std::size_t begin = skip_line_end(end);
    joined_.append(begin - end, ' ');
    end = line_end(begin);
    joined_.append(bytes_, begin, end - begin);
  }
  next_begin_ = skip_line_end(end);
  return joined_;
}

bool TextFile::next_line(std::string_view& line) {
  if (next_begin_ >= bytes_.size()) return false;
  line_begin_ = next_begin_;
  const std::size_t end = line_end(line_begin_);
  line = std::string_view(bytes_).substr(line_begin_, end - line_begin_);
  if (!line.empty() && line.back() == '\\') {
    line = join_lines(end);
  } else {
    next_begin_ = skip_line_end(end);
  }
  return true;
}

std::size_t TextFile::offset(std::string_view word) const {
  const bool joined =
      word.data() >= joined_.data() && word.data() <= joined_.data() + joined_.size();
  return joined ? line_begin_ + static_cast<std::size_t>(word.data() - joined_.data())
                : static_cast<std::size_t>(word.data() - bytes_.data());
}

std::string TextFile::position(std::size_t offset) const {
  if (offset < located_.offset) located_ = {};
  for (std::size_t& i = located_.offset; i < offset; ++i) {
    const bool lone_cr = bytes_[i] == '\r' && (i + 1 >= bytes_.size() || bytes_[i + 1] != '\n');
    if (bytes_[i] != '\n' && !lone_cr) continue;
    ++located_.line;
    located_.line_begin = i + 1;
  }
  return fmt::format("{}:{}:{}", path_.string(), located_.line, offset - located_.line_begin + 1);
}

void TextFile::fail(std::string_view word, const std::string& reason) const {
  fail(offset(word), reason);
}

void TextFile::fail(std::size_t offset, const std::string& reason) const {
  throw InputError(position(offset) + ": " + reason);
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool read_number(std::string_view word, double& value) {
  constexpr std::size_t longest = 300;
  if (word.size() > longest || has_huge_exponent(word)) return false;
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  // strtod would tell, but goes by the locale. So short a word is too small only by its exponent.
  if (error == std::errc::result_out_of_range) {
    if (word.find("e-") == word.npos && word.find("E-") == word.npos) return false;
    value = 0;
  }
  return error != std::errc::invalid_argument && stop == end && std::isfinite(value);
}

std::string number_fault(std::string_view word) {
  if (word.find(',') != word.npos) {
    return fmt::format("{} is not a number: write decimals with a point, not a comma", quote(word));
  }
  return fmt::format("{} is not a finite number", quote(word));
}

}  // namespace restframe

#include "importers/line_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "scene/error.h"

namespace restframe {
namespace {

constexpr std::size_t block = std::size_t{1} << 18U;

// A file of CR alone would be searched to its end for the LF of every line.
const char* find_line_end(const char* begin, const char* end, bool has_cr) {
  if (begin == end) return nullptr;
  if (!has_cr) {
    return static_cast<const char*>(
        std::memchr(begin, '\n', static_cast<std::size_t>(end - begin)));
  }
  const char* found = std::find_if(begin, end, [](char c) { return c == '\n' || c == '\r'; });
  return found == end ? nullptr : found;
}

}  // namespace

LineReader::LineReader(std::filesystem::path path, std::size_t limit)
    : path_(std::move(path)), file_(path_, path_.string()), unread_(file_.size()) {
  file_.check_size(limit);
  read_on();
  check_encoding();
}

void LineReader::check_encoding() {
  const std::string_view text(buffer_.data(), end_);
  const std::string_view start = text.substr(0, 2);
  const bool zeros = text.size() > 3 && ((!text[0] && text[1] && !text[2] && text[3]) ||
                                         (text[0] && !text[1] && text[2] && !text[3]));
  if (start == "\xFF\xFE" || start == "\xFE\xFF" || zeros) {
    fail(Place{1, 1}, "the text is UTF-16, must be UTF-8 or ASCII: save or convert it as UTF-8");
  }
  if (text.substr(0, 3) == "\xEF\xBB\xBF") std::fill_n(buffer_.begin(), 3, ' ');
}

// Moves what is left to the front and reads a block behind it; false if the file has no more.
bool LineReader::read_on() {
  if (unread_ == 0) return false;
  const std::size_t left = end_ - next_;
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(next_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  const std::size_t count = std::min(unread_, std::max(block, left));
  if (buffer_.size() < left + count) buffer_.resize(left + count);
  char* target = buffer_.data() + left;
  file_.read(target, count);
  unread_ -= count;
  next_ = 0;
  end_ = left + count;
  has_cr_ = has_cr_ || std::memchr(target, '\r', count) != nullptr;
  has_nul_ = has_nul_ || std::memchr(target, '\0', count) != nullptr;
  return true;
}

// Of the line that begins at next_, which is then in the buffer as a whole.
std::size_t LineReader::line_length() {
  std::size_t searched = 0;
  for (;;) {
    const char* begin = buffer_.data() + next_;
    const std::size_t count = end_ - next_;
    if (const char* stop = find_line_end(begin + searched, begin + count, has_cr_)) {
      return static_cast<std::size_t>(stop - begin);
    }
    searched = count;
    if (!read_on()) return count;
  }
}

bool LineReader::next_physical_line(std::string_view& line) {
  if (next_ == end_ && !read_on()) return false;
  if (after_cr_ && buffer_[next_] == '\n') {
    ++next_;
    after_cr_ = false;
    if (next_ == end_ && !read_on()) return false;
  }
  const std::size_t length = line_length();
  line = {buffer_.data() + next_, length};
  next_ += length;
  after_cr_ = next_ < end_ && buffer_[next_] == '\r';
  if (next_ < end_) ++next_;
  ++lines_;
  const std::size_t nul = has_nul_ ? line.find('\0') : line.npos;
  if (nul != line.npos) {
    fail(Place{lines_, nul + 1}, "a NUL byte: this is not a text file");
  }
  return true;
}

bool LineReader::next_line(std::string_view& line) {
  joints_.clear();
  if (!next_physical_line(line)) return false;
  if (!line.empty() && line.back() == '\\') {
    joined_.assign(line);
    while (!joined_.empty() && joined_.back() == '\\') {
      joined_.back() = ' ';
      if (!next_physical_line(line)) break;
      joints_.push_back(joined_.size());
      joined_.append(line);
    }
    line = joined_;
  }
  line_ = line;
  return true;
}

LineReader::Place LineReader::place(std::string_view word) const {
  const auto offset = static_cast<std::size_t>(word.data() - line_.data());
  const auto joint = std::upper_bound(joints_.begin(), joints_.end(), offset);
  const auto after = static_cast<std::uint64_t>(joints_.end() - joint);
  const std::size_t begin = joint == joints_.begin() ? 0 : *std::prev(joint);
  return {lines_ - after, offset - begin + 1};
}

std::string LineReader::position(Place place) const {
  return fmt::format("{}:{}:{}", path_.string(), place.line, place.column);
}

void LineReader::fail(std::string_view word, const std::string& reason) const {
  fail(place(word), reason);
}

void LineReader::fail(Place place, const std::string& reason) const {
  throw InputError(position(place) + ": " + reason);
}

}  // namespace restframe

#include "importers/byte_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t buffer_size = 65536;

}  // namespace

ByteReader::ByteReader(const std::filesystem::path& path, std::size_t limit)
    : name_(path.string()), file_(path, name_) {
  file_.check_size(limit);
}

std::string_view ByteReader::peek(std::size_t count) {
  count = std::min({count, left(), buffer_size});
  const std::size_t kept = buffer_begin_ + buffer_.size() - offset_;
  if (kept < count) {
    std::vector<char> next(std::min(left(), buffer_size));
    std::copy(buffer_.end() - static_cast<std::ptrdiff_t>(kept), buffer_.end(), next.begin());
    file_.read(next.data() + kept, next.size() - kept);
    buffer_.swap(next);
    buffer_begin_ = offset_;
  }
  return std::string_view(buffer_.data() + (offset_ - buffer_begin_), count);
}

void ByteReader::skip(std::size_t count) {
  if (count > left()) fail("the file ends early");
  while (count > 0) {
    const std::size_t step = peek(count).size();
    offset_ += step;
    count -= step;
  }
}

void ByteReader::fail(const std::string& reason) const {
  throw InputError(on_one_line(fmt::format("{}: byte {}: {}", name_, offset_, reason)));
}

}  // namespace restframe

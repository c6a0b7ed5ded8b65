#include "importers/ply_values.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scene/message.h"

namespace restframe {
namespace {

struct WholeRange {
  double low, high;
};

template <class Integer>
constexpr WholeRange range_of() {
  return {static_cast<double>(std::numeric_limits<Integer>::min()),
          static_cast<double>(std::numeric_limits<Integer>::max())};
}

// Nothing of floating point.
std::optional<WholeRange> whole_range(PlyType type) {
  switch (type) {
    case PlyType::int8:
      return range_of<std::int8_t>();
    case PlyType::uint8:
      return range_of<std::uint8_t>();
    case PlyType::int16:
      return range_of<std::int16_t>();
    case PlyType::uint16:
      return range_of<std::uint16_t>();
    case PlyType::int32:
      return range_of<std::int32_t>();
    case PlyType::uint32:
      return range_of<std::uint32_t>();
    default:
      return std::nullopt;
  }
}

}  // namespace

// Not by counting lines: those that end in a backslash are joined.
PlyText::PlyText(TextFile& file, std::size_t header_bytes) : words_(file) {
  constexpr std::size_t longest_line_end = 2;
  std::size_t end = 0;
  while (end < header_bytes && file.next_line(word_)) {
    end = file.offset(word_) + word_.size() + longest_line_end;
  }
}

double PlyText::next(PlyType type) {
  word_ = words_.next();
  if (word_.empty()) words_.fail_at_end("a number is missing");
  const double number = words_.number(word_);
  const auto range = whole_range(type);
  if (!range) return number;
  if (number == std::floor(number) && number >= range->low && number <= range->high) return number;
  fail(fmt::format("{}, must be a whole number from {} to {}", quote(word_), range->low,
                   range->high));
}

void PlyText::skip(PlyType type, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) next(type);
}

double PlyBytes::next(PlyType type) {
  switch (type) {
    case PlyType::int8:
      return file_.read<std::int8_t>(order_);
    case PlyType::uint8:
      return file_.read<std::uint8_t>(order_);
    case PlyType::int16:
      return file_.read<std::int16_t>(order_);
    case PlyType::uint16:
      return file_.read<std::uint16_t>(order_);
    case PlyType::int32:
      return file_.read<std::int32_t>(order_);
    case PlyType::uint32:
      return file_.read<std::uint32_t>(order_);
    case PlyType::float32:
      return static_cast<double>(file_.read<float>(order_));
    default:
      return file_.read<double>(order_);
  }
}

void PlyBytes::skip(PlyType type, std::uint64_t count) {
  if (count > file_.left() / size_of(type)) file_.fail("the file ends early");
  file_.skip(count * size_of(type));
}

}  // namespace restframe

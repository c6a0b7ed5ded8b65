#include "importers/text_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "scene/error.h"

namespace restframe {
namespace {

// "nan", "-inf", "1e400".
bool is_not_finite(std::string_view word) {
  double value = 0;
  if (word.substr(0, 1) == "+") word.remove_prefix(1);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  const bool is_one = stop == end && error != std::errc::invalid_argument;
  return is_one && (error == std::errc::result_out_of_range || !std::isfinite(value));
}

}  // namespace

std::string_view TextWords::next() {
  for (std::string_view word = next_on_line();; word = next_on_line()) {
    if (!word.empty() || !next_line()) return word;
  }
}

std::string_view TextWords::rest_of_line() {
  const std::string_view rest = trimmed(rest_);
  rest_ = {};
  return rest;
}

bool TextWords::next_line() {
  std::string_view line;
  while (file_.next_line(line)) {
    if (comment_ != '\0') line = line.substr(0, line.find(comment_));
    if (trimmed(line).empty()) continue;
    rest_ = line;
    return true;
  }
  rest_ = {};
  return false;
}

void TextWords::fail_at_end(const std::string& what) const {
  throw InputError(file_.path().string() + ": the file ends early: " + what);
}

double TextWords::number(std::string_view word) const {
  double value = 0;
  if (read_number(word, value)) return value;
  if (is_not_finite(word)) return std::numeric_limits<double>::quiet_NaN();
  fail(word, number_fault(word));
}

float TextWords::real(std::string_view word) const {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(number(word), -largest, largest));
}

}  // namespace restframe

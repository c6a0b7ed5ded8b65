#include "importers/value_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/suggest.h"

namespace restframe {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

bool is_number(const ConfigValue& value) {
  return std::holds_alternative<double>(value.data) ||
         std::holds_alternative<std::int64_t>(value.data);
}

double number_in(const ConfigValue& value) {
  const auto* integer = std::get_if<std::int64_t>(&value.data);
  return integer ? static_cast<double>(*integer) : std::get<double>(value.data);
}

}  // namespace

const char* kind_name(const ConfigValue& value) {
  static constexpr const char* names[] = {"true or false",  "a whole number", "a number", "a text",
                                          "a date or time", "an array",       "a table",  "null"};
  return names[value.data.index()];
}

void report_kind(const ConfigValue& value, const std::string& what, const std::string& wanted,
                 const Reporter& report) {
  report(value.at, fmt::format("{} is {}, must be {}", what, kind_name(value), wanted));
}

bool Range::contains(double x) const {
  return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
}

std::string Range::text() const {
  const bool has_low = low != -largest, has_high = high != largest;
  if (has_low && has_high && !low_open && !high_open)
    return fmt::format("from {} to {}", low, high);
  const std::string from = fmt::format("{} {}", low_open ? "above" : "at least", low);
  const std::string to = fmt::format("{} {}", high_open ? "below" : "at most", high);
  if (has_low && has_high) return from + " and " + to;
  return has_low ? from : to;
}

Range above(double low) {
  return {low, largest, true, false};
}
Range at_least(double low) {
  return {low, largest, false, false};
}
Range from_to(double low, double high) {
  return {low, high, false, false};
}
Range between(double low, double high) {
  return {low, high, true, true};
}

void Reporter::operator()(TextPosition at, const std::string& what) const {
  faults.add(at, name.empty() ? what : name + ": " + what);
}

std::optional<double> read_number(const ConfigValue& value, const std::string& what,
                                  const Range& range, const Reporter& report) {
  if (!is_number(value)) {
    report_kind(value, what, "a number", report);
    return std::nullopt;
  }
  const double x = number_in(value);
  if (!std::isfinite(x)) {
    report(value.at, fmt::format("{} is {}, must be a finite number", what, x));
  } else if (!range.contains(x)) {
    report(value.at, fmt::format("{} is {}, must be {}", what, x, range.text()));
  } else {
    return x;
  }
  return std::nullopt;
}

std::optional<std::string> read_text(const ConfigValue& value, const std::string& what,
                                     const Reporter& report) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (!text) {
    report_kind(value, what, "a text in quotes", report);
  } else if (text->empty()) {
    report(value.at, what + " is an empty text");
  } else if (text->find('\0') != std::string::npos) {
    report(value.at, what + " holds a NUL character");
  } else {
    return *text;
  }
  return std::nullopt;
}

std::optional<Vec3> read_vector(const ConfigValue& value, const std::string& what,
                                const Range& range, const Reporter& report) {
  const auto* array = std::get_if<ConfigArray>(&value.data);
  if (!array) {
    report_kind(value, what, "an array [x, y, z]", report);
    return std::nullopt;
  }
  if (array->size() != 3) {
    report(value.at, fmt::format("{} has {} elements, must have 3", what, array->size()));
    return std::nullopt;
  }
  Vec3 vector{0, 0, 0};
  bool good = true;
  for (int i = 0; i < 3; ++i) {
    const auto number = read_number((*array)[static_cast<std::size_t>(i)],
                                    fmt::format("{}[{}]", what, i), range, report);
    good = good && number;
    vector[i] = number.value_or(0);
  }
  return good ? std::optional(vector) : std::nullopt;
}

std::optional<std::int64_t> read_whole_number(const ConfigValue& value, const std::string& what,
                                              std::int64_t low, std::int64_t high,
                                              const Reporter& report) {
  const auto* number = std::get_if<std::int64_t>(&value.data);
  if (!number) {
    const std::string shown =
        is_number(value) ? fmt::format("{}", number_in(value)) : kind_name(value);
    report(value.at, fmt::format("{} is {}, must be a whole number", what, shown));
  } else if (*number < low || *number > high) {
    report(value.at, fmt::format("{} is {}, must be from {} to {}", what, *number, low, high));
  } else {
    return *number;
  }
  return std::nullopt;
}

std::optional<std::size_t> read_choice(TextPosition at, const std::string& chosen,
                                       const std::string& what,
                                       const std::vector<std::string>& names,
                                       const Reporter& report) {
  const auto found = std::find(names.begin(), names.end(), chosen);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  report(at, fmt::format("{} is \"{}\", must be one of {}; the nearest is \"{}\"", what, chosen,
                         fmt::join(names, ", "), nearest(chosen, names)));
  return std::nullopt;
}

}  // namespace restframe

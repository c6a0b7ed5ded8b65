#include "importers/value_rule.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/color.h"

namespace restframe {
namespace {

constexpr double largest_float = 3.4e38;

std::optional<Vec3f> read_triple(const ConfigValue& value, const std::string& what,
                                 const Range& range, const Reporter& report) {
  const std::optional<Vec3> triple = read_vector(value, what, range, report);
  return triple ? std::optional(Vec3f(*triple)) : std::nullopt;
}

}  // namespace

std::optional<TemporalValue> read_color_text(TextPosition at, const std::string& text,
                                             const std::string& what, const Reporter& report) {
  const std::optional<Vec3f> color = color_from_text(text);
  if (color) return color;
  if (!text.empty() && text.front() == '#') {
    report(at, fmt::format("{} is \"{}\", must be # and 3 or 6 hexadecimal digits", what, text));
  } else {
    report(at, fmt::format("{} is \"{}\", which is no colour; the nearest is \"{}\"", what, text,
                           nearest_color_name(text)));
  }
  return std::nullopt;
}

std::optional<TemporalValue> read_value(const ConfigValue& value, const std::string& what,
                                        const ValueRule& rule, const Reporter& report) {
  Range range = rule.range;
  range.high = std::min(range.high, largest_float);
  range.low = std::max(range.low, -largest_float);
  if (!rule.is_color) {
    const std::optional<double> number = read_number(value, what, range, report);
    return number ? std::optional(TemporalValue(static_cast<float>(*number))) : std::nullopt;
  }
  if (std::holds_alternative<ConfigArray>(value.data))
    return read_triple(value, what, range, report);
  if (const auto* text = std::get_if<std::string>(&value.data)) {
    return read_color_text(value.at, *text, what, report);
  }
  report(value.at, fmt::format("{} is {}, must be a colour: a name, \"#rrggbb\" or [r, g, b]", what,
                               kind_name(value)));
  return std::nullopt;
}

IntervalFunction make_intervals(std::optional<double> period, std::vector<PlacedInterval> placed,
                                const Reporter& report) {
  std::stable_sort(placed.begin(), placed.end(),
                   [](const PlacedInterval& a, const PlacedInterval& b) {
                     return a.interval.begin < b.interval.begin;
                   });
  IntervalFunction function{period, {}};
  for (const PlacedInterval& next : placed) {
    std::vector<std::string> faults = temporal_faults(IntervalFunction{period, {next.interval}});
    if (faults.empty() && !function.intervals.empty()) {
      faults = temporal_faults(
          IntervalFunction{std::nullopt, {function.intervals.back(), next.interval}});
    }
    for (const std::string& fault : faults) report(next.at, fault);
    if (faults.empty()) function.intervals.push_back(next.interval);
  }
  return function;
}

}  // namespace restframe

#include "importers/value_rule.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/color.h"

namespace restframe {
namespace {

constexpr double largest_float = 3.4e38;

// The value in single precision, if that can hold it.
std::optional<TemporalValue> narrowed(const std::optional<Vec3>& value, TextPosition at,
                                      const std::string& what, const Reporter& report) {
  if (!value) return std::nullopt;
  const Vec3 size = glm::abs(*value);
  if (std::max({size.x, size.y, size.z}) <= largest_float) return TemporalValue(*value);
  report(at, fmt::format("{} is too large, must be at most {}", what, largest_float));
  return std::nullopt;
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
  if (!rule.is_color) {
    const std::optional<double> number = read_number(value, what, rule.range, report);
    return narrowed(number ? std::optional(Vec3(*number)) : std::nullopt, value.at, what, report);
  }
  if (std::holds_alternative<ConfigArray>(value.data)) {
    return narrowed(read_vector(value, what, rule.range, report), value.at, what, report);
  }
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

void add_key(KeyFunction& function, const KeyFunction::Key& key, TextPosition at,
             const Reporter& report) {
  const std::size_t last = std::min<std::size_t>(2, function.keys.size());
  KeyFunction near{function.period,
                   {function.keys.end() - static_cast<std::ptrdiff_t>(last), function.keys.end()}};
  near.keys.push_back(key);
  const std::vector<std::string> faults = temporal_faults(near);
  for (const std::string& fault : faults) report(at, fault);
  if (faults.empty()) function.keys.push_back(key);
}

}  // namespace restframe

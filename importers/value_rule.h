#pragma once

#include <optional>
#include <string>

#include "importers/toml_reader.h"
#include "scene/temporal_function.h"

namespace restframe {

// What a material's property may be: a number or a colour, and the range of each of its numbers.
struct ValueRule {
  bool is_color = false;
  Range range;
};

// A colour by name or hexadecimal digits; the fault names the nearest colour.
std::optional<TemporalValue> read_color_text(TextPosition at, const std::string& text,
                                             const std::string& what, const Reporter& report);

// A number; or a colour, as text or as three linear numbers.
std::optional<TemporalValue> read_value(const ConfigValue& value, const std::string& what,
                                        const ValueRule& rule, const Reporter& report);

struct PlacedInterval {
  TextPosition at;
  IntervalFunction::Interval interval;
};

// Sorts the intervals into a function and reports, each at its place, those that can not be in one.
IntervalFunction make_intervals(std::optional<double> period, std::vector<PlacedInterval> placed,
                                const Reporter& report);

// Adds the key if it can follow those before it; else reports why not.
void add_key(KeyFunction& function, const KeyFunction::Key& key, TextPosition at,
             const Reporter& report);

}  // namespace restframe

#pragma once

// Temporal functions: a number or a colour over an object's clock (paper, section 4.3 and section
// 6). Plain data as a scene file states them; `TemporalEvaluator` compiles them for the ray path.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "physics/vectors.h"

namespace restframe {

// A colour is linear Rec. 709; a number is held in the first component.
using TemporalValue = Vec3f;

// Constant pieces, half-open [begin, end), sorted, without overlap; with a period they lie within
// [0, period). In a gap, and outside where there is no period, the property's own value holds.
struct IntervalFunction {
  struct Interval {
    double begin = 0, end = 0;
    TemporalValue value{0};
  };
  std::optional<double> period;
  std::vector<Interval> intervals;
};

// Piecewise linear through keys in strictly increasing time (two keys may share a time: a jump).
// With a period the keys lie within [0, period] and the function wraps; else it is held at both
// ends.
struct KeyFunction {
  struct Key {
    double time = 0;
    TemporalValue value{0};
  };
  std::optional<double> period;
  std::vector<Key> keys;
};

// One formula in t (seconds of the clock): a number's value, or the fraction from `from` to `to` of
// a colour. Three formulas: the linear components of a colour.
struct FormulaFunction {
  std::vector<std::string> formulas;
  std::optional<TemporalValue> from, to;
};

using TemporalFunction = std::variant<IntervalFunction, KeyFunction, FormulaFunction>;

// An index into Scene::functions.
using FunctionIndex = int;
inline constexpr FunctionIndex no_function = -1;

// A property that may change over the clock; `value` is the property's own value.
template <class T>
struct Temporal {
  T value{};
  FunctionIndex function = no_function;
};
using TemporalNumber = Temporal<float>;
using TemporalColor = Temporal<Vec3f>;

// Why `formula` can not be used ("unexpected ')' at 7"), or nothing if it can. Variables: t.
// Constant: pi.
std::optional<std::string> formula_fault(const std::string& formula);

// Every reason why `function` breaks the rules above, in words, without a position.
std::vector<std::string> temporal_faults(const TemporalFunction& function);

}  // namespace restframe

#include "scene/temporal_evaluator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/error.h"
#include "scene/formula.h"

namespace restframe {
namespace {

// Where in its period `time` falls, in [0, period). Just below a multiple of the period, rounding
// must not reach the period itself: there the end of the cycle holds. Far from zero the product has
// no digits left for the phase, but fmod is exact.
double phase(double time, double period) {
  const double quick = time - period * std::floor(time / period);
  if (quick >= 0 && quick < period) return quick;
  const double exact = std::fmod(time, period);
  return std::min(exact < 0 ? exact + period : exact, std::nextafter(period, 0.0));
}

std::optional<TemporalValue> evaluate(const IntervalFunction& function, double time) {
  const double at = function.period ? phase(time, *function.period) : time;
  const auto after = std::upper_bound(
      function.intervals.begin(), function.intervals.end(), at,
      [](double t, const IntervalFunction::Interval& interval) { return t < interval.begin; });
  if (after == function.intervals.begin() || at >= std::prev(after)->end) return std::nullopt;
  return std::prev(after)->value;
}

TemporalValue evaluate(const KeyFunction& function, double time) {
  const auto& keys = function.keys;
  const double at = function.period ? phase(time, *function.period) : time;
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), at,
                       [](double t, const KeyFunction::Key& key) { return t < key.time; });
  const bool before_first = after == keys.begin();
  const bool past_last = after == keys.end();
  if (!function.period && before_first) return keys.front().value;
  if (!function.period && past_last) return keys.back().value;

  // Between the last key and the first of the next period the function runs on.
  const KeyFunction::Key& left = before_first ? keys.back() : *std::prev(after);
  const KeyFunction::Key& right = past_last ? keys.front() : *after;
  const double left_time = before_first ? left.time - *function.period : left.time;
  const double right_time = past_last ? right.time + *function.period : right.time;
  const double fraction = (at - left_time) / (right_time - left_time);
  return glm::mix(left.value, right.value, static_cast<float>(fraction));
}

}  // namespace

// The formulas of one function; none for the other kinds, which are evaluated as they are.
struct TemporalEvaluator::Compiled {
  std::vector<std::unique_ptr<Formula>> formulas;
};

namespace {

TemporalValue evaluate(const FormulaFunction& function,
                       const std::vector<std::unique_ptr<Formula>>& formulas, double time) {
  const auto component = [&](std::size_t i) { return (*formulas[i])(time); };
  if (formulas.size() == 3) return TemporalValue(component(0), component(1), component(2));
  const double value = component(0);
  if (!function.from) return TemporalValue(static_cast<float>(value));
  return *function.from + static_cast<float>(value) * (*function.to - *function.from);
}

}  // namespace

TemporalEvaluator::TemporalEvaluator(const std::vector<TemporalFunction>& functions)
    : functions_(functions) {
  for (const TemporalFunction& function : functions_) {
    const std::vector<std::string> faults = temporal_faults(function);
    if (!faults.empty()) throw InputError("temporal function: " + faults.front());
    compiled_.push_back(std::make_unique<Compiled>());
    const auto* formula = std::get_if<FormulaFunction>(&function);
    if (!formula) continue;
    for (const std::string& text : formula->formulas) {
      compiled_.back()->formulas.push_back(std::make_unique<Formula>(text));
    }
  }
}

TemporalEvaluator::TemporalEvaluator(const TemporalEvaluator& other)
    : TemporalEvaluator(other.functions_) {}

TemporalEvaluator::~TemporalEvaluator() = default;

TemporalValue TemporalEvaluator::value(FunctionIndex function, double time,
                                       const TemporalValue& own) {
  const auto index = static_cast<std::size_t>(function);
  std::optional<TemporalValue> found;
  if (!std::isfinite(time)) {
    found = TemporalValue(std::numeric_limits<float>::quiet_NaN());
  } else if (const auto* intervals = std::get_if<IntervalFunction>(&functions_[index])) {
    found = evaluate(*intervals, time);
  } else if (const auto* keys = std::get_if<KeyFunction>(&functions_[index])) {
    found = evaluate(*keys, time);
  } else {
    found =
        evaluate(std::get<FormulaFunction>(functions_[index]), compiled_[index]->formulas, time);
  }
  if (!found) return own;
  if (is_finite(*found)) return *found;
  if (fault_.function == no_function) fault_ = {function, time};
  return own;
}

}  // namespace restframe

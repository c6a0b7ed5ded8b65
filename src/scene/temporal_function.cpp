#include "scene/temporal_function.h"

#include <fmt/format.h>

#include <cmath>

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

void check_period(const std::optional<double>& period, Faults& faults) {
  if (period && !(std::isfinite(*period) && *period > 0)) {
    faults.push_back(fmt::format("the period is {}, must be above 0 and finite", *period));
  }
}

std::string name_of(const IntervalFunction::Interval& interval) {
  return fmt::format("the interval from {} to {}", interval.begin, interval.end);
}

void check_interval(const IntervalFunction::Interval& interval, const std::optional<double>& period,
                    Faults& faults) {
  if (!std::isfinite(interval.begin) || !std::isfinite(interval.end)) {
    faults.push_back(name_of(interval) + " is not finite");
  } else if (interval.begin >= interval.end) {
    faults.push_back(name_of(interval) + " is empty, its end must come after its beginning");
  } else if (period && *period > 0 && (interval.begin < 0 || interval.end > *period)) {
    faults.push_back(fmt::format("{} leaves the period, 0 to {}", name_of(interval), *period));
  }
  if (!is_finite(interval.value)) {
    faults.push_back("the value of " + name_of(interval) + " is not finite");
  }
}

Faults faults_of(const IntervalFunction& function) {
  Faults faults;
  check_period(function.period, faults);
  if (function.intervals.empty()) faults.push_back("there are no intervals");
  const IntervalFunction::Interval* before = nullptr;
  for (const IntervalFunction::Interval& interval : function.intervals) {
    check_interval(interval, function.period, faults);
    if (before && interval.begin < before->begin) {
      faults.push_back(name_of(interval) + " comes before its predecessor");
    } else if (before && interval.begin < before->end) {
      faults.push_back(fmt::format("{} overlaps that from {} to {}", name_of(interval),
                                   before->begin, before->end));
    }
    before = &interval;
  }
  return faults;
}

void check_key(const KeyFunction& function, std::size_t i, Faults& faults) {
  const KeyFunction::Key& key = function.keys[i];
  const std::string name = fmt::format("the key at time {}", key.time);
  if (!std::isfinite(key.time) || !is_finite(key.value)) {
    faults.push_back(name + " is not finite");
  } else if (function.period && *function.period > 0 &&
             (key.time < 0 || key.time > *function.period)) {
    faults.push_back(fmt::format("{} leaves the period, 0 to {}", name, *function.period));
  }
  if (i > 0 && key.time < function.keys[i - 1].time) {
    faults.push_back(fmt::format("{} is out of order, the one before it is at {}", name,
                                 function.keys[i - 1].time));
  }
  if (i > 1 && key.time == function.keys[i - 2].time) {
    faults.push_back(name + " is the third at that time, there may be two (a jump)");
  }
}

Faults faults_of(const KeyFunction& function) {
  Faults faults;
  check_period(function.period, faults);
  if (function.keys.empty()) faults.push_back("there are no keys");
  for (std::size_t i = 0; i < function.keys.size(); ++i) check_key(function, i, faults);
  return faults;
}

Faults faults_of(const FormulaFunction& function) {
  Faults faults;
  const std::size_t count = function.formulas.size();
  if (count != 1 && count != 3) {
    faults.push_back(fmt::format("there are {} formulas, must be one or three", count));
  }
  for (const std::string& formula : function.formulas) {
    if (const auto fault = formula_fault(formula)) {
      faults.push_back(fmt::format("the formula \"{}\" can not be used: {}", formula, *fault));
    }
  }
  if (function.from.has_value() != function.to.has_value() || (function.from && count == 3)) {
    faults.push_back("from and to go together, with one formula");
  }
  if ((function.from && !is_finite(*function.from)) || (function.to && !is_finite(*function.to))) {
    faults.push_back("from and to must be finite");
  }
  return faults;
}

}  // namespace

Faults temporal_faults(const TemporalFunction& function) {
  return std::visit([](const auto& kind) { return faults_of(kind); }, function);
}

}  // namespace restframe

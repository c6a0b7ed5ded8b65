#pragma once

#include <memory>
#include <vector>

#include "scene/temporal_function.h"

namespace restframe {

// Temporal functions compiled for the ray path: evaluation neither allocates nor locks. Formulas
// keep state, so each thread has its own copy (copying compiles again).
class TemporalEvaluator {
 public:
  // A formula gave something that is not finite.
  struct Fault {
    FunctionIndex function = no_function;
    double time = 0;
  };

  explicit TemporalEvaluator(const std::vector<TemporalFunction>& functions);
  TemporalEvaluator(const TemporalEvaluator& other);
  TemporalEvaluator& operator=(const TemporalEvaluator&) = delete;
  ~TemporalEvaluator();

  // The value at clock time `time` (seconds); `own` where the function says nothing. A value that
  // is not finite is replaced by `own` and noted as a fault.
  TemporalValue value(FunctionIndex function, double time, const TemporalValue& own);

  float operator()(const TemporalNumber& number, double time) {
    return number.function == no_function
               ? number.value
               : value(number.function, time, TemporalValue(number.value)).x;
  }
  Vec3f operator()(const TemporalColor& color, double time) {
    return color.function == no_function ? color.value : value(color.function, time, color.value);
  }

  // The first fault met, if any.
  const Fault& fault() const { return fault_; }

 private:
  struct Compiled;
  std::vector<TemporalFunction> functions_;
  std::vector<std::unique_ptr<Compiled>> compiled_;
  Fault fault_;
};

}  // namespace restframe

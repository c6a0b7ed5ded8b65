#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "scene/temporal_evaluator.h"

namespace restframe {

// One evaluator for each thread that is at work; a tile borrows one and brings it back.
class EvaluatorPool {
 public:
  explicit EvaluatorPool(const std::vector<TemporalFunction>& functions) : original_(functions) {}

  std::unique_ptr<TemporalEvaluator> take() {
    const std::scoped_lock lock(mutex_);
    if (idle_.empty()) return std::make_unique<TemporalEvaluator>(original_);
    std::unique_ptr<TemporalEvaluator> evaluator = std::move(idle_.back());
    idle_.pop_back();
    return evaluator;
  }

  void bring_back(std::unique_ptr<TemporalEvaluator> evaluator) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(evaluator));
  }

 private:
  std::mutex mutex_;
  TemporalEvaluator original_;
  std::vector<std::unique_ptr<TemporalEvaluator>> idle_;
};

}  // namespace restframe

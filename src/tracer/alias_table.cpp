#include "tracer/alias_table.h"

#include <numeric>

namespace restframe {

AliasTable::AliasTable(std::span<const double> weights)
    : bins_(weights.size()), chances_(weights.size(), 0.0F) {
  total_ = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(total_ > 0.0)) return;
  const auto count = static_cast<double>(weights.size());
  std::vector<double> own(weights.size());
  std::vector<std::uint32_t> poor, rich;
  for (std::uint32_t i = 0; i < bins_.size(); ++i) {
    chances_[i] = static_cast<float>(weights[i] / total_);
    own[i] = weights[i] / total_ * count;
    bins_[i].other = i;
    (own[i] < 1.0 ? poor : rich).push_back(i);
  }
  while (!poor.empty() && !rich.empty()) {
    const std::uint32_t low = poor.back(), high = rich.back();
    poor.pop_back();
    bins_[low].own = static_cast<float>(own[low]);
    bins_[low].other = high;
    own[high] -= 1.0 - own[low];
    if (own[high] >= 1.0) continue;
    rich.pop_back();
    poor.push_back(high);
  }
  // Rounding has left others: they are full.
}

}  // namespace restframe

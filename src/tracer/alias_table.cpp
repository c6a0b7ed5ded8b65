#include "tracer/alias_table.h"

#include <numeric>

namespace restframe {

AliasTable::AliasTable(std::span<const double> weights)
    : bins_(weights.size()), chances_(weights.size(), 0.0) {
  total_ = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(total_ > 0.0)) return;
  const auto count = static_cast<double>(weights.size());
  std::vector<std::uint32_t> poor, rich;
  for (std::uint32_t i = 0; i < bins_.size(); ++i) {
    chances_[i] = weights[i] / total_;
    bins_[i] = {chances_[i] * count, i};
    (bins_[i].own < 1.0 ? poor : rich).push_back(i);
  }
  while (!poor.empty() && !rich.empty()) {
    const std::uint32_t low = poor.back(), high = rich.back();
    poor.pop_back();
    bins_[low].other = high;
    bins_[high].own -= 1.0 - bins_[low].own;
    if (bins_[high].own >= 1.0) continue;
    rich.pop_back();
    poor.push_back(high);
  }
  // Rounding has left them: they are full.
  for (const std::uint32_t i : poor) bins_[i].own = chances_[i] > 0.0 ? 1.0 : 0.0;
  for (const std::uint32_t i : rich) bins_[i].own = 1.0;
}

}  // namespace restframe

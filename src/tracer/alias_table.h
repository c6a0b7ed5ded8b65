#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace restframe {

// Chooses among many in constant time, each in proportion to its weight (Walker's alias method,
// tables made as Vose 1991 has it).
class AliasTable {
 public:
  AliasTable() = default;
  // Weights of 0 or more. If all are 0, so are all chances.
  explicit AliasTable(std::span<const double> weights);

  std::size_t size() const { return bins_.size(); }
  double total() const { return total_; }

  // u: in [0, 1). The table is not empty.
  std::uint32_t choose(double u) const { return choose_and_reuse(u); }

  // Leaves in `u` another number in [0, 1), of the digits that the choice did not need.
  std::uint32_t choose_and_reuse(double& u) const {
    const double place = u * static_cast<double>(bins_.size());
    const auto bin = static_cast<std::uint32_t>(place);
    const double within = place - bin, own = static_cast<double>(bins_[bin].own);
    const bool takes_own = within < own;
    u = std::min(takes_own ? within / own : (within - own) / (1.0 - own), 1.0 - 0x1p-53);
    return takes_own ? bin : bins_[bin].other;
  }

  double chance(std::uint32_t index) const { return static_cast<double>(chances_[index]); }

 private:
  struct Bin {
    float own = 1;  // the part of the bin that is its own; the rest is the other's
    std::uint32_t other = 0;
  };
  std::vector<Bin> bins_;
  std::vector<float> chances_;
  double total_ = 0;
};

}  // namespace restframe

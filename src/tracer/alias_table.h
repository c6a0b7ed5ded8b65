#pragma once

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
  std::uint32_t choose(double u) const {
    const double place = u * static_cast<double>(bins_.size());
    const auto bin = static_cast<std::uint32_t>(place);
    return place - bin < bins_[bin].own ? bin : bins_[bin].other;
  }

  double chance(std::uint32_t index) const { return chances_[index]; }

 private:
  struct Bin {
    double own = 1;  // the part of the bin that is its own; the rest is the other's
    std::uint32_t other = 0;
  };
  std::vector<Bin> bins_;
  std::vector<double> chances_;
  double total_ = 0;
};

}  // namespace restframe

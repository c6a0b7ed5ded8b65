#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/settings.h"
#include "tracer/sample.h"
#include "tracer/sample_parts.h"

namespace restframe {

// What the light of 16 pixels consists of: the same samples and exposures as the beauty's, added up in
// double.
class PartTotals {
 public:
  // columns: of SampleParts; must outlive the totals.
  PartTotals(std::span<const int> columns, const ExposureSettings& settings)
      : settings_(settings), columns_(columns) {
    if (!are_wanted()) return;
    sums_.assign(columns.size(), Vec3Lanes{});
    sample_.emplace();
  }

  bool are_wanted() const { return !columns_.empty(); }
  // To be filled by the tracer with the next sample of any exposure, then added; null: not wanted.
  SampleParts* sample() { return sample_ ? &*sample_ : nullptr; }
  void add_sample();

  // What pixel `lane` has after all exposures of so many samples each, a colour a column. Colours, the
  // albedo too, are premultiplied by the coverage of the exposures' mean.
  void take(int lane, int samples, std::span<Vec3f> colors) const;
  std::size_t size() const { return columns_.size(); }

 private:
  const ExposureSettings& settings_;
  std::span<const int> columns_;
  std::vector<Vec3Lanes> sums_;        // of each column
  std::optional<SampleParts> sample_;  // kilobytes that cost nothing where no part is wanted
};

}  // namespace restframe

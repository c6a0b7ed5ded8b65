#pragma once

#include "scene/settings.h"
#include "tracer/sample.h"

namespace restframe {

// The exposures of one picture taken together, pixel by pixel, as they come.
class ExposureTotal {
 public:
  explicit ExposureTotal(const ExposureSettings& settings)
      : combine_(settings.combine), share_(1.0F / static_cast<float>(settings.count)) {}

  // The next exposure: `scale` times what its samples add up to.
  void add(const RadianceLanes& samples, float scale) {
    if (share_ != 1.0F) add_alpha(samples, scale);
    if (is_first_) {
      for (int i = 0; i < packet_size; ++i) total_[i] = scale * samples[i];
    } else {
      for (int i = 0; i < packet_size; ++i) {
        total_[i] = taken_together(total_[i], scale * samples[i]);
      }
    }
    is_first_ = false;
  }

  // After combined(): how much more is covered than the mean of the exposures covers, where they add up.
  Lanes<float> alpha_over_mean() const {
    Lanes<float> ratio;
    ratio.fill(1.0F);
    for (int i = 0; share_ != 1.0F && i < packet_size; ++i) {
      if (alpha_[i] > 0.0F) ratio[i] = total_[i].w / (alpha_[i] * share_);
    }
    return ratio;
  }

  // After the last one.
  const RadianceLanes& combined() {
    if (combine_ == Combine::mean && share_ != 1.0F) {
      for (Vec4f& pixel : total_.lane) pixel *= share_;
    }
    return total_;
  }

 private:
  void add_alpha(const RadianceLanes& samples, float scale) {
    for (int i = 0; i < packet_size; ++i) {
      alpha_[i] = (is_first_ ? 0.0F : alpha_[i]) + scale * samples[i].w;
    }
  }

  Vec4f taken_together(const Vec4f& total, const Vec4f& next) const {
    switch (combine_) {
      case Combine::sum: {
        // Light adds up; what covers, covers what is left: 1 - product of (1 - alpha).
        Vec4f sum = total + next;
        sum.w = total.w + (1.0F - total.w) * next.w;
        return sum;
      }
      case Combine::mean:
        return total + next;
      case Combine::max:
        break;
    }
    return glm::max(total, next);
  }

  Combine combine_;
  float share_;
  bool is_first_ = true;
  RadianceLanes total_;
  Lanes<float> alpha_;  // of all exposures, added up
};

}  // namespace restframe

#pragma once

// A block of which is known how sure its pixels are: until they are sure enough, or all samples are
// taken.

#include "app/render_block.h"
#include "app/signals.h"
#include "film/replicates.h"
#include "scene/error.h"

namespace restframe {

// How many samples of each exposure are there after the next batch. Decisions cost nothing, but each is
// a chance to stop by luck: batches grow with what is there.
inline int samples_after_batch(int samples, int most) {
  constexpr int smallest = 16;
  return std::min(most, samples + std::max(smallest, samples / 2 / smallest * smallest));
}

// What light covers, over several exposures that add up: 1 - product of (1 - alpha) is no sum over
// samples.
class CoverageOfSum {
 public:
  explicit CoverageOfSum(const ExposureSettings& settings)
      : sums_(settings.combine == Combine::sum && settings.count > 1
                  ? static_cast<std::size_t>(settings.count)
                  : 0,
              Lanes<float>{}) {}

  bool is_wanted() const { return !sums_.empty(); }
  void add(int exposure, const RadianceLanes& radiance) {
    if (!is_wanted()) return;
    Lanes<float>& sum = sums_[static_cast<std::size_t>(exposure)];
    for (int i = 0; i < packet_size; ++i) sum[i] += radiance[i].w;
  }
  float coverage(int lane, int samples) const {
    float uncovered = 1.0F;
    for (const Lanes<float>& sum : sums_) {
      uncovered *= 1.0F - sum[lane] / static_cast<float>(samples);
    }
    return 1.0F - uncovered;
  }

 private:
  std::vector<Lanes<float>> sums_;  // of each exposure
};

template <class Tracer>
struct MeasuredBlock {
  Block<Tracer>& block;
  Replicates replicates;
  CoverageOfSum coverage;
  float scale;  // of one exposure
  // Those that decide when all are sure: of the display, where the block holds any of it. So they are as
  // they are without overscan.
  Lanes<std::int32_t> judged;

  PartTotals parts;

  MeasuredBlock(Block<Tracer>& of, const Picture& picture)
      : block(of), coverage(exposure()), parts(picture.part_columns(), exposure()) {
    const bool mean = exposure().combine == Combine::mean;
    scale = mean ? 1.0F / static_cast<float>(exposure().count) : 1.0F;
    judge();
    const int most = most_samples();
    const int a_replicate = (most + replicate_count - 1) / replicate_count;
    bits_ = bits_for(a_replicate);
    block.id.sample_bits = static_cast<std::uint32_t>(bits_ + bits_for(exposure().count));
  }

  const ExposureSettings& exposure() const { return block.view.context.scene.exposure; }
  int most_samples() const { return block.view.context.scene.render.samples; }

  // The samples [first, end) of an exposure.
  void take(int number, int first, int end) {
    for (int sample = first; sample < end; ++sample) {
      if (interrupt_requested()) throw Interrupted();
      block.id.replicate = static_cast<std::uint32_t>(sample % replicate_count);
      block.id.sample = (static_cast<std::uint32_t>(number) << bits_) |
                        static_cast<std::uint32_t>(sample / replicate_count);
      PacketRandom random(block.id);
      CameraSample where;
      block.view.sampler.draw(block.pixels, random, where);
      RadianceLanes radiance;
      trace(block, number, where, radiance, {nullptr, block.covers, parts.sample()});
      if (parts.are_wanted()) parts.add_sample();
      replicates.add(sample % replicate_count, radiance, scale);
      coverage.add(number, radiance);
      if (number == 0) replicates.count(sample % replicate_count);
    }
  }

  void take_all() {
    const double wanted = block.view.context.scene.render.noise;
    for (int samples = 0; samples < most_samples();) {
      const int end = samples_after_batch(samples, most_samples());
      for (int number = 0; number < exposure().count; ++number) take(number, samples, end);
      samples = end;
      if (wanted > 0.0 && replicates.noise(judged) <= wanted) break;
    }
  }

  void store_in(Picture& picture) const {
    RadianceLanes radiance;
    for (int i = 0; i < packet_size; ++i) {
      radiance[i] = replicates.mean(i);
      if (coverage.is_wanted()) radiance[i].w = coverage.coverage(i, replicates.samples());
    }
    store(block, radiance, picture);
    store_parts(block, parts, replicates.samples(), picture);
    const int samples = replicates.samples() * exposure().count;
    if (block.covers != nullptr) {
      store_mattes(block, samples, alpha_over_mean(radiance), picture);
    }
    if (!picture.has_statistics()) return;
    for_pixels(block, [&](int x, int y, int lane) {
      picture.set_statistics(x, y, {replicates.variance(lane), samples});
    });
  }

 private:
  // Of `radiance`, the exposures together, as ExposureTotal::alpha_over_mean.
  Lanes<float> alpha_over_mean(const RadianceLanes& radiance) const {
    const auto count =
        static_cast<float>(exposure().combine == Combine::mean ? 1 : exposure().count);
    Lanes<float> ratio;
    for (int i = 0; i < packet_size; ++i) {
      const float mean = replicates.mean(i).w / count;
      ratio[i] = mean > 0.0F ? radiance[i].w / mean : 1.0F;
    }
    return ratio;
  }

  void judge() {
    judged = block.active;
    const PixelWindow display = display_window(block.view.context.scene.render);
    const PixelWindow shown = common_part({block.left, block.top, block_side, block_side}, display);
    if (shown.width == 0 || shown.height == 0) return;
    for (int i = 0; i < packet_size; ++i) {
      judged[i] = contains(shown, {block.pixels.x[i], block.pixels.y[i], 1, 1}) ? -1 : 0;
    }
  }

  int bits_ = 0;  // of the samples of an exposure in a replicate
};

template <class Tracer>
void render_measured(Block<Tracer>& block, Picture& picture) {
  MeasuredBlock<Tracer> measured(block, picture);
  measured.take_all();
  measured.store_in(picture);
}

}  // namespace restframe

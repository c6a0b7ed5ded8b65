#include "tracer/camera_sampler.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "physics/clones.h"
#include "tracer/film_samples.h"
#include "tracer/lens.h"

namespace restframe {
namespace {

// About the golden section of `samples`, and without a common factor: steps of it visit every
// sample once.
std::size_t coprime_stride(std::size_t samples) {
  auto stride = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(samples));
  while (std::gcd(stride, samples) != 1) ++stride;
  return stride;
}

// film_offsets() begins at the centre, which data layers hold where nothing is spread over time.
// Over a shutter's time they come with strides, since neighbours in that sequence are related.
std::vector<Vec2f> ordered_offsets(int samples, bool over_time) {
  std::vector<Vec2f> offsets = film_offsets(samples);
  if (!over_time) return offsets;
  const std::size_t stride = coprime_stride(offsets.size());
  std::vector<Vec2f> ordered(offsets.size());
  for (std::size_t i = 0; i < offsets.size(); ++i)
    ordered[i] = offsets[i * stride % offsets.size()];
  return ordered;
}

double fraction(double x) {
  return x - std::floor(x);
}

}  // namespace

CameraSampler::CameraSampler(const Scene& scene)
    : shutter_(scene.exposure),
      offsets_(ordered_offsets(scene.render.samples, !shutter_.is_instant())),
      aperture_(scene.camera.aperture),
      rolling_per_pixel_(scene.camera.rolling / scene.render.height) {}

void CameraSampler::start(const PacketId& id, Starts& starts) const {
  if (!spreads()) return;
  PacketRandom random(id);
  for (int i = 0; i < packet_size; ++i) {
    starts.moment[i] = static_cast<double>(random(i, Dimension::time, 0));
    starts.lens_u[i] = static_cast<double>(random(i, Dimension::lens_u, 0));
    starts.lens_v[i] = static_cast<double>(random(i, Dimension::lens_v, 0));
  }
}

void CameraSampler::place_on_film(const PixelLanes& pixels, int index, CameraSample& sample) const {
  const Vec2f offset = offsets_[static_cast<std::size_t>(index)];
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    sample.film_x[i] = pixels.x[i] + 0.5 + static_cast<double>(offset.x);
    sample.film_y[i] = pixels.y[i] + 0.5 + static_cast<double>(offset.y);
  }
}

void CameraSampler::place_on_lens(const Starts& starts, int index, CameraSample& sample) const {
  for (int i = 0; i < packet_size; ++i) {
    const double u = fraction(starts.lens_u[i] + index * (std::numbers::sqrt2 - 1.0));
    const double v = fraction(starts.lens_v[i] + index * (std::numbers::sqrt3 - 1.0));
    const Vec2 point = aperture_ * on_unit_disc(u, v);
    sample.lens_x[i] = point.x;
    sample.lens_y[i] = point.y;
  }
}

void CameraSampler::place_in_time(const Starts& starts, int index, CameraSample& sample) const {
  if (shutter_.is_instant()) {
    sample.after_opening.fill(0.0);
    return;
  }
  constexpr double root_5 = 2.23606797749978969641;
  const double part = 1.0 / static_cast<double>(offsets_.size());
  const double shift = fraction(index * (root_5 - 2.0));
#pragma GCC ivdep
  for (int i = 0; i < packet_size; ++i) {
    sample.after_opening[i] = (index + fraction(starts.moment[i] + shift)) * part;
  }
  shutter_.quantiles(sample.after_opening);
}

void CameraSampler::add_rolling(CameraSample& sample) const {
  for (int i = 0; i < packet_size; ++i) {
    sample.after_opening[i] += rolling_per_pixel_ * sample.film_y[i];
  }
}

RESTFRAME_CLONES void CameraSampler::take(const PixelLanes& pixels, const Starts& starts, int index,
                                          CameraSample& sample) const {
  place_on_film(pixels, index, sample);
  if (is_instant() && !has_lens()) return;  // nobody asks for the rest
  place_in_time(starts, index, sample);
  if (rolling_per_pixel_ > 0.0) add_rolling(sample);
  if (has_lens()) place_on_lens(starts, index, sample);
}

void CameraSampler::draw(const PixelLanes& pixels, PacketRandom& random,
                         CameraSample& sample) const {
  const auto drawn = [&](Dimension dimension, int lane) {
    return static_cast<double>(random(lane, dimension, 0));
  };
  for (int i = 0; i < packet_size; ++i) {
    sample.film_x[i] = pixels.x[i] + 0.5 + tent_quantile(drawn(Dimension::film_u, i));
    sample.film_y[i] = pixels.y[i] + 0.5 + tent_quantile(drawn(Dimension::film_v, i));
  }
  sample.after_opening.fill(0.0);
  if (!shutter_.is_instant()) {
    for (int i = 0; i < packet_size; ++i) {
      sample.after_opening[i] = drawn(Dimension::time, i);
    }
    shutter_.quantiles(sample.after_opening);
  }
  if (rolling_per_pixel_ > 0.0) add_rolling(sample);
  for (int i = 0; has_lens() && i < packet_size; ++i) {
    const double u = drawn(Dimension::lens_u, i);
    const Vec2 point = aperture_ * on_unit_disc(u, drawn(Dimension::lens_v, i));
    sample.lens_x[i] = point.x;
    sample.lens_y[i] = point.y;
  }
}

void CameraSampler::take_center(const PixelLanes& pixels, CameraSample& sample) const {
  for (int i = 0; i < packet_size; ++i) {
    sample.film_x[i] = pixels.x[i] + 0.5;
    sample.film_y[i] = pixels.y[i] + 0.5;
  }
  sample.after_opening.fill(0.0);
  sample.lens_x.fill(0.0);
  sample.lens_y.fill(0.0);
  add_rolling(sample);
}

}  // namespace restframe

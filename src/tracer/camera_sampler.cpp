#include "tracer/camera_sampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tracer/film_samples.h"
#include "tracer/lens.h"

namespace restframe {
namespace {

// About the golden section of `samples`, and without a common factor: steps of it visit every
// sample once, neighbours in time far apart in the sequence.
std::uint32_t coprime_stride(std::uint32_t samples) {
  auto stride = static_cast<std::uint32_t>(0.6180339887498949 * samples);
  while (std::gcd(stride, samples) != 1) ++stride;
  return stride;
}

double fraction(double x) {
  return x - std::floor(x);
}

}  // namespace

CameraSampler::CameraSampler(const Scene& scene)
    : offsets_(film_offsets(scene.render.samples)),
      shutter_(scene.exposure),
      aperture_(scene.camera.aperture),
      rolling_per_pixel_(scene.camera.rolling / scene.render.height),
      stride_(coprime_stride(static_cast<std::uint32_t>(scene.render.samples))) {}

void CameraSampler::start(const PacketId& id, Starts& starts) const {
  if (!shutter_.is_instant()) {
    const auto samples = static_cast<float>(offsets_.size());
    for (int i = 0; i < packet_size; ++i) {
      const float u = random_unit(id, i, Dimension::time, 1);
      starts.film[i] = std::min(static_cast<std::uint32_t>(u * samples),
                                static_cast<std::uint32_t>(offsets_.size() - 1));
      starts.moment[i] = static_cast<double>(random_unit(id, i, Dimension::time, 0));
    }
  }
  if (has_lens()) {
    for (int i = 0; i < packet_size; ++i) {
      starts.lens_u[i] = static_cast<double>(random_unit(id, i, Dimension::lens, 0));
      starts.lens_v[i] = static_cast<double>(random_unit(id, i, Dimension::lens, 1));
    }
  }
}

Lanes<std::uint32_t> CameraSampler::film_indices(const Starts& starts, int index) const {
  Lanes<std::uint32_t> indices;
  if (shutter_.is_instant()) {
    indices.fill(static_cast<std::uint32_t>(index));
    return indices;
  }
  const std::uint64_t strides = std::uint64_t{stride_} * static_cast<std::uint32_t>(index);
  const auto samples = static_cast<std::uint32_t>(offsets_.size());
  const auto step = static_cast<std::uint32_t>(strides % samples);
  for (int i = 0; i < packet_size; ++i) {
    const std::uint32_t n = starts.film[i] + step;
    indices[i] = n < samples ? n : n - samples;
  }
  return indices;
}

void CameraSampler::place_on_film(const PixelLanes& pixels, const Starts& starts, int index,
                                  CameraSample& sample) const {
  Lanes<float> x, y;
  if (shutter_.is_instant()) {
    const Vec2f& offset = offsets_[static_cast<std::size_t>(index)];
    x.fill(offset.x);
    y.fill(offset.y);
  } else {
    const Lanes<std::uint32_t> indices = film_indices(starts, index);
    for (int i = 0; i < packet_size; ++i) {
      const Vec2f& offset = offsets_[indices[i]];
      x[i] = offset.x;
      y[i] = offset.y;
    }
  }
  for (int i = 0; i < packet_size; ++i) {
    sample.film_x[i] = pixels.x[i] + 0.5 + static_cast<double>(x[i]);
    sample.film_y[i] = pixels.y[i] + 0.5 + static_cast<double>(y[i]);
  }
}

void CameraSampler::place_on_lens(const Starts& starts, int index, CameraSample& sample) const {
  if (!has_lens()) {
    sample.lens_x.fill(0.0);
    sample.lens_y.fill(0.0);
    return;
  }
  const Lanes<std::uint32_t> indices = film_indices(starts, index);
  for (int i = 0; i < packet_size; ++i) {
    const double n = indices[i];
    const double u = fraction(starts.lens_u[i] + n * (std::numbers::sqrt2 - 1.0));
    const double v = fraction(starts.lens_v[i] + n * (std::numbers::sqrt3 - 1.0));
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

void CameraSampler::take(const PixelLanes& pixels, const Starts& starts, int index,
                         CameraSample& sample) const {
  place_on_film(pixels, starts, index, sample);
  if (is_instant() && !has_lens()) return;  // nobody asks for the rest
  place_in_time(starts, index, sample);
  add_rolling(sample);
  place_on_lens(starts, index, sample);
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

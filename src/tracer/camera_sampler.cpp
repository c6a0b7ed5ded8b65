#include "tracer/camera_sampler.h"

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
      starts.film[i] = static_cast<std::uint32_t>(u * samples);
    }
  }
  if (has_lens()) {
    for (int i = 0; i < packet_size; ++i) {
      starts.lens_u[i] = static_cast<double>(random_unit(id, i, Dimension::lens, 0));
      starts.lens_v[i] = static_cast<double>(random_unit(id, i, Dimension::lens, 1));
    }
  }
}

std::uint32_t CameraSampler::film_index(const Starts& starts, int lane, int index) const {
  if (shutter_.is_instant()) return static_cast<std::uint32_t>(index);
  const std::uint64_t steps =
      starts.film[lane] + std::uint64_t{stride_} * static_cast<unsigned>(index);
  return static_cast<std::uint32_t>(steps % offsets_.size());
}

void CameraSampler::place_on_film(const PixelLanes& pixels, const Starts& starts, int index,
                                  CameraSample& sample) const {
  Lanes<float> x, y;
  if (shutter_.is_instant()) {
    const Vec2f& offset = offsets_[static_cast<std::size_t>(index)];
    x.fill(offset.x);
    y.fill(offset.y);
  } else {
    for (int i = 0; i < packet_size; ++i) {
      const Vec2f& offset = offsets_[film_index(starts, i, index)];
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
  for (int i = 0; i < packet_size; ++i) {
    const double n = film_index(starts, i, index);
    const double u = fraction(starts.lens_u[i] + n * (std::numbers::sqrt2 - 1.0));
    const double v = fraction(starts.lens_v[i] + n * (std::numbers::sqrt3 - 1.0));
    const Vec2 point = aperture_ * on_unit_disc(u, v);
    sample.lens_x[i] = point.x;
    sample.lens_y[i] = point.y;
  }
}

void CameraSampler::place_in_time(const PacketId& id, int index, CameraSample& sample) const {
  if (shutter_.is_instant()) {
    sample.after_opening.fill(0.0);
    return;
  }
  const double part = 1.0 / static_cast<double>(offsets_.size());
  for (int i = 0; i < packet_size; ++i) {
    const auto jitter = static_cast<double>(random_unit(id, i, Dimension::time, 0));
    sample.after_opening[i] = (index + jitter) * part;
  }
  shutter_.quantiles(sample.after_opening);
}

void CameraSampler::add_rolling(CameraSample& sample) const {
  for (int i = 0; i < packet_size; ++i) {
    sample.after_opening[i] += rolling_per_pixel_ * sample.film_y[i];
  }
}

void CameraSampler::take(const PacketId& id, const PixelLanes& pixels, const Starts& starts,
                         int index, CameraSample& sample) const {
  place_on_film(pixels, starts, index, sample);
  if (is_instant() && !has_lens()) return;  // nobody asks for the rest
  place_in_time(id, index, sample);
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

#include "tracer/emitter_spectrum.h"

#include <algorithm>
#include <cmath>

namespace restframe {
namespace {

// Standard deviation over full width at half maximum, 1 / sqrt(8 ln 2).
constexpr double deviation_of_width = 0.42466090014400953;

// By standard deviation over wavelength: below, a line is one wavelength, or three; and above, it is
// so broad that wavelengths chosen for the rest meet it often enough.
constexpr double one_wavelength = 5e-4, three_wavelengths = 4e-3, broad = 1.6e-2;

constexpr int temperatures = 256;  // from the coldest to the hottest

double temperature_step() {
  return std::log(hottest_kelvin / coldest_kelvin) / (temperatures - 1);
}

// The energy between two points of straight lines.
double piece_energy(const SpectrumPoint& a, const SpectrumPoint& b) {
  return static_cast<double>(b.wavelength - a.wavelength) * static_cast<double>(a.value + b.value) /
         2;
}

// Likewise its luminance, in steps that see each piece, however narrow.
double piece_luminance(const SpectrumPoint& a, const SpectrumPoint& b) {
  const auto begin = static_cast<double>(a.wavelength), end = static_cast<double>(b.wavelength);
  const double from = std::max(begin, visible_from), to = std::min(end, visible_to);
  if (!(to > from)) return 0;
  const int steps = static_cast<int>(std::ceil((to - from) / 0.25));
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double w = from + (i + 0.5) / steps * (to - from);
    const double value = glm::mix(static_cast<double>(a.value), static_cast<double>(b.value),
                                  (w - begin) / (end - begin));
    sum += value * color_matching(w).y;
  }
  return sum * (to - from) / steps;
}

}  // namespace

EmitterSpectrum::EmitterSpectrum(const TemporalNumber& temperature,
                                 const EmissionSpectrum& spectrum) {
  if (!has_own_spectrum(temperature, spectrum)) return;
  kind_ = Kind::dark;
  if (!spectrum.points.empty()) {
    set_measured(spectrum.points);
  } else if (temperature.function != no_function) {
    kind_ = Kind::blackbody;
  } else if (temperature.value > 0.0F) {
    kind_ = Kind::blackbody;
    constant_.emplace(static_cast<double>(temperature.value));
  }
  for (const EmissionLine& line : spectrum.lines) add_line(line);
  set_colors();
}

void EmitterSpectrum::set_measured(const std::vector<SpectrumPoint>& points) {
  kind_ = Kind::measured;
  points_ = points;
  double luminance = 0, energy = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    luminance += piece_luminance(points[i - 1], points[i]);
    energy += piece_energy(points[i - 1], points[i]);
  }
  scale_ = 1 / (luminance > 0 ? luminance : energy);
}

double EmitterSpectrum::measured(double wavelength) const {
  const auto after = std::upper_bound(points_.begin(), points_.end(), wavelength,
                                      [](double w, const SpectrumPoint& point) {
                                        return w < static_cast<double>(point.wavelength);
                                      });
  if (after == points_.begin() || after == points_.end()) return 0;
  const SpectrumPoint &a = *std::prev(after), &b = *after;
  const double fraction = (wavelength - static_cast<double>(a.wavelength)) /
                          static_cast<double>(b.wavelength - a.wavelength);
  return scale_ * glm::mix(static_cast<double>(a.value), static_cast<double>(b.value), fraction);
}

// Gaussian quadrature for what is narrow; equal steps, which converge at once for a Gaussian, for
// what is wider.
void EmitterSpectrum::add_line(const EmissionLine& line) {
  const auto wavelength = static_cast<double>(line.wavelength);
  const auto power = static_cast<double>(line.power);
  const double deviation = deviation_of_width * static_cast<double>(line.width);
  const double relative = deviation / wavelength;
  const auto add = [&](double deviations, double share) {
    lines_.push_back({static_cast<float>(wavelength + deviations * deviation),
                      static_cast<float>(power * share)});
  };
  if (relative >= broad) {
    constexpr double inverse_sqrt_2_pi = 0.39894228040143268;
    broad_lines_.push_back({wavelength, power * inverse_sqrt_2_pi / deviation, 1 / deviation});
  } else if (relative < one_wavelength) {
    add(0, 1);
  } else if (relative < three_wavelengths) {
    add(0, 2.0 / 3);
    for (const double side : {-1.0, 1.0}) add(side * std::sqrt(3.0), 1.0 / 6);
  } else {
    double sum = 0;
    for (int i = -4; i <= 4; ++i) sum += std::exp(-0.5 * i * i);
    for (int i = -4; i <= 4; ++i) add(i, std::exp(-0.5 * i * i) / sum);
  }
}

float EmitterSpectrum::own(double wavelength, const Vec4f& table, float kelvin) const {
  double sum = 0;
  switch (kind_) {
    case Kind::daylight:
      sum = static_cast<double>(table.w);
      break;
    case Kind::blackbody:
      sum =
          constant_ ? (*constant_)(wavelength) : Blackbody(static_cast<double>(kelvin))(wavelength);
      break;
    case Kind::measured:
      sum = measured(wavelength);
      break;
    case Kind::dark:
      break;
  }
  for (const Peak& peak : broad_lines_) {
    const double deviations = (wavelength - peak.wavelength) * peak.inverse_deviation;
    sum += peak.height * std::exp(-0.5 * deviations * deviations);
  }
  return static_cast<float>(sum);
}

Vec3f EmitterSpectrum::seen(const Observer& observer, const Vec3f& filter, float kelvin,
                            double doppler) const {
  const SpectrumTable& table = SpectrumTable::get();
  const auto d = static_cast<float>(doppler);
  Vec3f sum(0);
  for (const Observer::Part& part : observer.parts()) {
    const float wavelength = part.wavelength * d;
    const Vec4f values = table(wavelength);
    const float passes = glm::dot(Vec3f(values), filter);
    sum += part.rgb * (passes * d * (*this)(wavelength, values, kelvin));
  }
  for (const Line& line : lines_) {
    const float passes = glm::dot(Vec3f(table(line.wavelength)), filter);
    const Vec3 response = observer.response(static_cast<double>(line.wavelength) / doppler);
    sum += Vec3f(response) * (passes * line.power);
  }
  return sum;
}

// Of what never changes by halves of a nanometre, since measured spectra may have peaks.
void EmitterSpectrum::set_colors() {
  const Observer eye(std::nullopt);
  const auto lines = [&](const Vec3& filter) {
    Vec3 sum(0);
    for (const Line& line : lines_) {
      const auto w = static_cast<double>(line.wavelength);
      sum += rgb_matching(w) *
             (glm::dot(reflectance_basis(w), filter) * static_cast<double>(line.power));
    }
    return sum;
  };
  const auto all = [&](const Vec3& filter) {
    return visible_integral([&](double w) {
      const double passes = glm::dot(reflectance_basis(w), filter);
      return rgb_matching(w) * (passes * static_cast<double>(own(w, Vec4f(0), 0.0F)));
    });
  };
  const bool changes = kind_ == Kind::blackbody && !constant_;
  for (int t = 0; t < (changes ? temperatures : 1); ++t) {
    const double kelvin = coldest_kelvin * std::exp(t * temperature_step());
    glm::mat3 columns;
    for (int i = 0; i < 3; ++i) {
      Vec3 filter(0);
      filter[i] = 1;
      columns[i] = changes ? seen(eye, Vec3f(filter), static_cast<float>(kelvin), 1)
                           : Vec3f(all(filter) + lines(filter));
    }
    colors_.push_back(columns);
  }
}

glm::mat3 EmitterSpectrum::color_matrix(float kelvin) const {
  if (colors_.size() == 1) return colors_.front();
  const double t = std::clamp(static_cast<double>(kelvin), coldest_kelvin, hottest_kelvin);
  const double at = std::log(t / coldest_kelvin) / temperature_step();
  const int index = std::clamp(static_cast<int>(at), 0, temperatures - 2);
  const auto fraction = static_cast<float>(at - index);
  const auto i = static_cast<std::size_t>(index);
  return colors_[i] + (colors_[i + 1] - colors_[i]) * fraction;
}

Vec3f EmitterSpectrum::color(const Vec3f& filter, float kelvin) const {
  return is_daylight() ? filter : color_matrix(kelvin) * filter;
}

SceneSpectra::SceneSpectra(const Scene& scene)
    : shifts(scene.render.doppler),
      observer(scene.render.observe),
      light_count(scene.lights.size()),
      table(SpectrumTable::get()) {
  for (const Material& material : scene.materials) {
    all.emplace_back(material.emission_temperature, material.emission_spectrum);
  }
  for (const Light& light : scene.lights) all.emplace_back(light.temperature, light.spectrum);
  matters = shifts;
  if (shifts) shifted.emplace(observer);
  for (const EmitterSpectrum& spectrum : all) {
    has_lines = has_lines || spectrum.has_lines();
    matters = matters || spectrum.is_own();
  }
}

}  // namespace restframe

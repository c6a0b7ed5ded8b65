#pragma once

// The spectra of what emits, ready for the ray path.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "physics/observer.h"
#include "physics/spectrum.h"
#include "physics/spectrum_table.h"
#include "scene/scene.h"

namespace restframe {

// Light of one emitter by wavelength, in its rest frame, where its strength is 1 and its colour
// white. A colour is a filter before it: it lets through what a surface of that colour reflects.
class EmitterSpectrum {
 public:
  // D65.
  EmitterSpectrum() = default;
  EmitterSpectrum(const TemporalNumber& temperature, const EmissionSpectrum& spectrum);

  // Then a colour is its light, and nothing need be done where light is not followed by wavelength.
  bool is_daylight() const { return kind_ == Kind::daylight; }
  bool is_own() const { return !is_daylight(); }
  bool has_lines() const { return !lines_.empty(); }

  // Spectral radiance but for the lines; `table` holds SpectrumTable's values there.
  float operator()(float wavelength, const Vec4f& table, float kelvin) const {
    return is_daylight() ? table.w : own(static_cast<double>(wavelength), table, kelvin);
  }

  // The lines, but for those that are so broad that they count with the rest: wavelengths with the
  // power around each, so many that no eye tells them from a Gaussian.
  struct Line {
    float wavelength = 0, power = 0;
  };
  const std::vector<Line>& lines() const { return lines_; }

  // How all of it is seen through a filter by an observer who has it shifted by D: without chance,
  // but slow.
  Vec3f seen(const Observer& observer, const Vec3f& filter, float kelvin, double doppler) const;

  // Linear Rec. 709 of what passes a filter.
  Vec3f color(const Vec3f& filter, float kelvin) const;

 private:
  enum class Kind { daylight, blackbody, measured, dark };
  struct Peak {
    double wavelength, height, inverse_deviation;
  };
  float own(double wavelength, const Vec4f& table, float kelvin) const;
  double measured(double wavelength) const;
  void set_measured(const std::vector<SpectrumPoint>& points);
  void add_line(const EmissionLine& line);
  void set_colors();
  glm::mat3 color_matrix(float kelvin) const;

  Kind kind_ = Kind::daylight;
  std::optional<Blackbody> constant_;  // of a temperature that never changes
  std::vector<SpectrumPoint> points_;
  double scale_ = 1;
  std::vector<Peak> broad_lines_;
  std::vector<Line> lines_;
  // Columns: the colours that red, green and blue filters make; of a temperature that changes, at
  // equal ratios of it.
  std::vector<glm::mat3> colors_;
};

// How D65 light of a colour is seen by an observer who has it shifted: linear in the colour.
class ShiftedDaylight {
 public:
  explicit ShiftedDaylight(const Observer& observer);
  Vec3f operator()(const Vec3f& color, double doppler) const;

 private:
  glm::mat3 matrix_at(double doppler) const;
  const Observer& observer_;
  std::vector<glm::mat3> matrices_;  // at equal ratios of D
};

// The spectra of a scene.
struct SceneSpectra {
  explicit SceneSpectra(const Scene& scene);
  SceneSpectra(const SceneSpectra&) = delete;  // shifted refers to the observer
  SceneSpectra& operator=(const SceneSpectra&) = delete;

  // Of the materials, then of the lights.
  const EmitterSpectrum& operator[](std::int32_t index) const {
    return all[static_cast<std::size_t>(index)];
  }
  std::int32_t of_material(std::int32_t material) const { return material; }
  std::int32_t of_light(std::ptrdiff_t light) const {
    return static_cast<std::int32_t>(all.size() - light_count) + static_cast<std::int32_t>(light);
  }

  bool shifts;           // light is followed by wavelength, which shifts
  bool matters = false;  // or else: something has a spectrum of its own
  bool has_lines = false;
  Observer observer;
  std::optional<ShiftedDaylight> shifted;  // where it shifts
  EmitterSpectrum daylight;
  std::vector<EmitterSpectrum> all;
  std::size_t light_count;
  const SpectrumTable& table;
};

}  // namespace restframe

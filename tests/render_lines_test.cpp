// Emission lines: their colours when they move past, over mirrors and coloured surfaces, without
// noise; and bands other than the visible one.

#include <gtest/gtest.h>

#include <numbers>

#include "physics/observer.h"
#include "support/doppler_scene.h"

namespace restframe {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlpha = 656.28, kBeta = 486.13;  // hydrogen's Balmer lines

// The value where it does not matter how wide a line is.
void expect_rgb(const Vec3& seen, const Vec3& right, double tolerance) {
  const double size = std::max({std::abs(right.x), std::abs(right.y), std::abs(right.z), 1e-6});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i] / size, right[i] / size, tolerance);
}

std::string glowing_patch(const std::string& keys) {
  return "[[material]]\nname = \"patch\"\nbase_color = \"black\"\n" + keys + "\n";
}

Vec3 glow(const std::string& render_keys, double beta, const std::string& material_keys) {
  const std::string text =
      axis_camera(render_keys) + square_object(beta) + glowing_patch(material_keys);
  return mean_of(path_pictures(text, {kSquare})[0]).rgb;
}

TEST(Lines, ShiftAsTheyMovePast) {
  for (const std::string integrator : {"preview", "path"}) {
    const std::string keys = "samples = 1\ndoppler = true\nintegrator = \"" + integrator + "\"";
    for (const double beta : {0.0, 0.1, 0.2, 0.3, 0.35, -0.05, -0.2}) {
      SCOPED_TRACE(fmt::format("{} at {}", integrator, beta));
      const double d = head_on_doppler(beta);
      const Vec3 right = 50.0 * rgb_matching(kAlpha / d) + 10.0 * rgb_matching(kBeta / d);
      const std::string lines = "emission_lines = [[656.28, 50, 0.01], [486.13, 10, 0.01]]";
      expect_rgb(glow(keys, beta, lines), right, 1e-3);
      expect_rgb(glow(keys + "\nbeaming = true", beta, lines), right * std::pow(d, 4), 1e-3);
    }
  }
}

// H alpha goes from red over green to blue as it comes faster; and is gone.
TEST(Lines, HydrogenChangesColor) {
  const auto seen = [](double beta) {
    return glow("samples = 1\ndoppler = true", beta, "emission_lines = [[656.28, 10]]");
  };
  const Vec3 rest = seen(0), green = seen(0.2), blue = seen(0.35), gone = seen(0.6);
  EXPECT_GT(rest.x, 3 * std::max(rest.y, rest.z));
  EXPECT_GT(green.y, 3 * std::max(green.x, green.z));
  EXPECT_GT(blue.z, 3 * std::max(blue.x, blue.y));
  EXPECT_LT(glm::length(gone), 0.01);
}

// Whether few wavelengths stand for a line, or it counts with what has no lines.
TEST(Lines, MayBeOfAnyWidth) {
  for (const double width : {0.1, 2.0, 12.0, 30.0, 80.0}) {
    const double deviation = width / std::sqrt(8 * std::log(2.0));
    const auto spectrum = [&](double w) {
      return 10 * std::exp(-0.5 * std::pow((w - 550) / deviation, 2)) /
             (deviation * std::sqrt(2 * kPi));
    };
    for (const double beta : {0.0, 0.15}) {
      SCOPED_TRACE(fmt::format("{} nm at {}", width, beta));
      const Vec3 right = linear_from_xyz(shifted_xyz(head_on_doppler(beta), spectrum));
      const std::string lines = fmt::format("emission_lines = [[550, 10, {}]]", width);
      expect_rgb(glow("samples = 64\ndoppler = true\nintegrator = \"path\"", beta, lines), right,
                 1e-2);
      if (beta == 0) expect_rgb(glow("samples = 1", beta, lines), right, 2e-3);
    }
  }
}

// A lamp of lines that lights a coloured surface in motion: the surface reflects by the wavelength
// that the light has there.
TEST(Lines, LightColoredSurfaces) {
  const Vec3 rgb(0.8, 0.4, 0.1);
  for (const double surface : {0.0, 0.3, -0.3}) {
    for (const double lamp : {0.0, 0.2}) {
      SCOPED_TRACE(fmt::format("surface at {}, lamp at {}", surface, lamp));
      const std::string text = axis_camera("samples = 2\ndoppler = true\nintegrator = \"path\"") +
                               square_object(surface) + diffuse_patch(rgb) +
                               moving_sun(lamp, 40, "lines = [[620, 1, 0.01], [530, 1, 0.01]]");
      const Vec3 seen = mean_of(path_pictures(text, {kSquare})[0]).rgb;
      const double d = head_on_doppler(surface);
      // The sun's light goes along -z; one that moves along +z trails it.
      const double d_lamp = d * head_on_doppler(surface) / head_on_doppler(lamp);
      Vec3 right(0);
      for (const double line : {620.0, 530.0}) {
        const double at_surface = line / d_lamp * d;
        right += rgb_matching(line / d_lamp) * reflected(rgb, at_surface);
      }
      // Energy per area that a plane wave brings goes with the square of its frequency; without
      // beaming, the emitter's factor is 1.
      const double flux = std::pow(d_lamp / d, -2);
      expect_rgb(seen, right * (40 / kPi * flux), 2e-3);
    }
  }
}

// By way of a tinted mirror, which is met between camera and lamp.
TEST(Lines, ComeByMirrors) {
  const Vec3 tint(0.9, 0.3, 0.2);
  for (const double beta : {0.0, 0.1, -0.1}) {
    const double d = head_on_doppler(beta);
    const std::string text =
        axis_camera("samples = 4\nintegrator = \"path\"\ndoppler = true\n") +
        square_object(beta, "mirror") +
        "[[object]]\nname = \"lamp\"\nasset = \"square.obj\"\nposition = [0, 0, 10]\nscale = 50\n"
        "rotation = [0, 180, 0]\nmaterial = \"lamp\"\n[[material]]\nname = \"lamp\"\nbase_color = "
        "\"black\"\nemission_lines = [[589.3, 20, 0.01]]\nemission = [1, 0.5, 0.5]\n"
        "[[material]]\nname = \"mirror\"\nmetallic = 1\nroughness = 0\nbase_color = " +
        rgb_text(tint) + "\n";
    const Vec3 seen = mean_of(path_pictures(text, {kSquare})[0]).rgb;
    const Vec3 right = rgb_matching(589.3 / (d * d)) *
                       (20 * reflected({1, 0.5, 0.5}, 589.3) * reflected(tint, 589.3 / d));
    expect_rgb(seen, right, 2e-3);
  }
}

double triangle(double w, double from, double to) {
  const double middle = (from + to) / 2;
  return std::max(0.0, 1 - std::abs(w - middle) / (to - middle));
}

// Of luminance 1 at rest; or, where that is none, of energy 1.
TEST(Measured, SpectraShift) {
  const auto table = [](double from, double to) {
    return fmt::format("emission_spectrum = [[{}, 0], [{}, 7], [{}, 0]]\nemission_strength = 3",
                       from, (from + to) / 2, to);
  };
  const double luminance = shifted_xyz(1, [](double w) { return triangle(w, 500, 620); }).y;
  for (const std::string integrator : {"preview", "path"}) {
    const std::string keys = "samples = 16\nintegrator = \"" + integrator + "\"\n";
    for (const double beta : {0.0, 0.15, -0.1}) {
      const Vec3 seen = glow(keys + "doppler = true", beta, table(500, 620));
      expect_rgb(seen,
                 linear_from_xyz(
                     shifted_xyz(head_on_doppler(beta),
                                 [&](double w) { return 3 * triangle(w, 500, 620) / luminance; })),
                 1e-2);
    }
    const Vec3 visible = glow(keys, 0, table(500, 620));
    EXPECT_NEAR(glm::dot(visible, Vec3(0.2126, 0.7152, 0.0722)), 3, 0.01);
    const Vec3 shifted = glow(keys + "doppler = true", -0.6, table(200, 300));
    expect_rgb(
        shifted,
        linear_from_xyz(shifted_xyz(0.5, [&](double w) { return 3 * triangle(w, 200, 300) / 50; })),
        1e-2);
  }
}

// The colour of a lamp over its own clock, and a filter before it.
TEST(Temperature, MayChange) {
  for (const std::string keys : {"", "doppler = true"}) {
    const std::string text =
        axis_camera("integrator = \"path\"\nsamples = 16\n" + keys) + square_object(0) +
        diffuse_patch({1, 1, 1}) +
        moving_sun(0, kPi,
                   "color = [0.5, 0.25, 0.25]\ntemperature = {keys = [[-4000, 2000], [0, 6000]]}");
    const Vec3 seen = mean_of(path_pictures(text, {kSquare})[0]).rgb;
    // The wavefront that is at z = -1000 at time -1000 left the sun's place, the origin, at -2000.
    const double kelvin = 4000;
    const double luminance = shifted_xyz(1, [&](double w) { return planck(w, kelvin); }).y;
    const Vec3 right = linear_from_xyz(shifted_xyz(1, [&](double w) {
      return planck(w, kelvin) * reflected({0.5, 0.25, 0.25}, w) / luminance;
    }));
    expect_rgb(seen, right, 3e-3);
  }
}

// Light of a band, by thirds: what each has over what D65 light of luminance 1 has.
struct Band {
  double from, to;

  std::string keys() const {
    return fmt::format("doppler = true\nobserve = {{from = {}, to = {}}}\n", from, to);
  }
  double edge(int i) const { return to * std::pow(from / to, i / 3.0); }
  template <class Spectrum>
  Vec3 energy(const Spectrum& spectrum) const {
    constexpr int steps = 3000;
    Vec3 sum(0);
    for (int third = 0; third < 3; ++third) {
      const double ratio = std::pow(edge(third) / edge(third + 1), 1.0 / steps);
      for (int i = 0; i < steps; ++i) {
        const double w = edge(third + 1) * std::pow(ratio, i + 0.5);
        sum[third] += spectrum(w) * w * std::log(ratio);
      }
    }
    return sum;
  }
  Vec3 white() const {
    return energy([](double w) { return std::max(daylight(w), 1e-9 * daylight(560)); });
  }
};

TEST(Observe, ShowsWhiteAsWhite) {
  for (const Band& band : {Band{2000, 4000}, Band{200, 350}, Band{8000, 14'000}}) {
    for (const std::string integrator : {"preview", "path"}) {
      const Vec3 seen = glow(band.keys() + "samples = 16\nintegrator = \"" + integrator + "\"", 0,
                             "emission = \"white\"");
      expect_rgb(seen, Vec3(1), 3e-3);
    }
  }
}

TEST(Observe, SeesHotThings) {
  const Band band{2000, 4000};
  const double luminance = shifted_xyz(1, [](double w) { return planck(w, 1500); }).y;
  for (const double beta : {0.0, 0.5, -0.5}) {
    const double d = head_on_doppler(beta);
    const Vec3 seen = glow(band.keys() + "samples = 16\nintegrator = \"path\"", beta,
                           "emission_temperature = 1500\nemission_strength = 0.01");
    const Vec3 right = band.energy([&](double w) {
      return d * planck(w * d, 1500) * 0.01 / luminance;
    }) / band.white();
    expect_rgb(seen, right, 3e-3);
  }
}

// The energy of all wavelengths stays what it is with doppler alone, and goes with D^4 with both.
TEST(Observe, EnergyOfAllWavelengthsIsKept) {
  const Band all{30, 100'000};
  const auto energy = [&](const std::string& keys, double beta, const std::string& material) {
    const Vec3 seen =
        glow(all.keys() + keys + "samples = 256\nintegrator = \"path\"", beta, material);
    return glm::dot(seen, all.white());
  };
  const Vec3 daylight_energy = all.energy([](double w) { return daylight(w); });
  const double right = daylight_energy.x + daylight_energy.y + daylight_energy.z;
  for (const double beta : {0.0, 0.6, -0.6}) {
    const double d4 = std::pow(head_on_doppler(beta), 4);
    EXPECT_NEAR(energy("", beta, "emission = \"white\"") / right, 1, 4e-3) << beta;
    EXPECT_NEAR(energy("beaming = true\n", beta, "emission = \"white\"") / (right * d4), 1, 4e-3);
    const std::string lines =
        "emission_lines = [[121.567, 2, 0.1], [656.28, 3, 0.5], [5000, 1, 9]]";
    EXPECT_NEAR(energy("", beta, lines) / 6, 1, 2e-3) << beta;
  }
}

}  // namespace
}  // namespace restframe

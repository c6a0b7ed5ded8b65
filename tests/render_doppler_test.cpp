// Pictures with `doppler`: at rest they are those without; patches of all colours in motion look as a
// direct integration over wavelengths says; blackbodies keep closed form 12.

#include <gtest/gtest.h>

#include <numbers>

#include "support/color_difference.h"
#include "support/doppler_scene.h"

namespace restframe {
namespace {

constexpr double kPi = std::numbers::pi;
const Vec3 kColors[] = {{1, 1, 1},       {0.2, 0.2, 0.2},   {1, 0, 0},        {0, 1, 0},
                        {0, 0, 1},       {0.9, 0.35, 0.05}, {0.05, 0.3, 0.6}, {0.35, 0.5, 0.1},
                        {0.6, 0.1, 0.5}, {0.02, 0.02, 0.02}};
const double kBetas[] = {0, 0.3, 0.6, 0.9, -0.3, -0.6, -0.9};

PictureMean patch(const Vec3& rgb, double beta, double irradiance, const std::string& keys) {
  const std::string text = axis_camera("integrator = \"path\"\ndepth = 1\nsamples = 16\n" + keys) +
                           square_object(beta) + diffuse_patch(rgb) + moving_sun(beta, irradiance);
  return mean_of(path_pictures(text, {kSquare})[0]);
}

// The pairs of Sharma and others that each test one branch of the formula.
TEST(ColorDifference, IsThatOfCie142) {
  using reference::delta_e_2000;
  EXPECT_NEAR(delta_e_2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(delta_e_2000({50, 2.49, -0.001}, {50, -2.49, 0.0009}), 7.1792, 1e-4);
  EXPECT_NEAR(delta_e_2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
  EXPECT_NEAR(delta_e_2000({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}), 0.9082, 1e-4);
}

// 1 - (1 - a)^(1/n) for a = 0.001 and 30 comparisons: |z| below 4.2.
TEST(Doppler, AtRestChangesNothingInExpectation) {
  for (const Vec3& rgb : kColors) {
    const PictureMean with = patch(rgb, 0, kPi, "doppler = true");
    const PictureMean without = patch(rgb, 0, kPi, "");
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(without.rgb[i], rgb[i], 1e-3);
      // Half floats, the table's straight lines, and noise.
      EXPECT_NEAR(with.rgb[i], without.rgb[i], 5e-4 + 4.2 * with.error[i]) << rgb_text(rgb);
      EXPECT_LT(with.error[i] * 16, 0.02 * std::max(0.1, without.rgb[i])) << rgb_text(rgb);
    }
  }
}

// What the patch sends to the camera with `irradiance` 1, as XYZ.
Vec3 expected_xyz(const Vec3& rgb, double beta) {
  return shifted_xyz(head_on_doppler(beta),
                     [&](double w) { return daylight(w) * reflected(rgb, w) / kPi; });
}

Vec3 xyz_from_rgb(const Vec3& rgb) {
  const Mat3 linear(linear_from_xyz({1, 0, 0}), linear_from_xyz({0, 1, 0}),
                    linear_from_xyz({0, 0, 1}));
  return glm::inverse(linear) * rgb;
}

void expect_patch(const Vec3& rgb, double beta) {
  SCOPED_TRACE(fmt::format("{} at {}", rgb_text(rgb), beta));
  const Vec3 expected = expected_xyz(rgb, beta);
  const double irradiance = 0.5 / expected.y;  // half of white's luminance
  const Vec3 seen = xyz_from_rgb(patch(rgb, beta, irradiance, "doppler = true").rgb);
  EXPECT_NEAR(seen.y, 0.5, 0.01);
  const double difference =
      reference::delta_e_2000(reference::lab_from_xyz(seen * (0.5 / seen.y)),
                              reference::lab_from_xyz(expected * (0.5 / expected.y)));
  EXPECT_LT(difference, 1);
}

TEST(Doppler, PatchesLookAsIntegrated) {
  for (const double beta : kBetas) {
    for (const Vec3& rgb : kColors) expect_patch(rgb, beta);
  }
}

// D of radiance by wavelength, and D^4 more with both.
TEST(Doppler, BeamsByTheFifthPower) {
  for (const double beta : {0.5, -0.5}) {
    const Vec3 only = patch({1, 1, 1}, beta, kPi, "doppler = true").rgb;
    const Vec3 both = patch({1, 1, 1}, beta, kPi, "doppler = true\nbeaming = true").rgb;
    const double d4 = std::pow(head_on_doppler(beta), 4);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(both[i] / (d4 * only[i]), 1, 2e-3);
  }
}

PictureMean glowing(double kelvin, double beta, const std::string& keys) {
  const std::string text =
      axis_camera("samples = 16\n" + keys) + square_object(beta) +
      fmt::format(
          "[[material]]\nname = \"patch\"\nbase_color = \"black\"\nemission_temperature = "
          "{}\nemission_strength = 4\n",
          kelvin);
  return mean_of(path_pictures(text, {kSquare})[0]);
}

// Of luminance 4 at rest.
Vec3 blackbody_rgb(double kelvin, double seen_as) {
  const double luminance = shifted_xyz(1, [&](double w) { return planck(w, kelvin); }).y;
  return linear_from_xyz(shifted_xyz(1, [&](double w) { return planck(w, seen_as); })) *
         (4 / luminance);
}

// Closed form 12, with both switches on.
TEST(Doppler, MovingBlackbodiesAreSeenAtAnotherTemperature) {
  for (const std::string integrator : {"preview", "path"}) {
    for (const double beta : {0.0, 0.3, 0.8, -0.3, -0.6}) {
      for (const double kelvin : {2500.0, 6000.0, 20'000.0}) {
        SCOPED_TRACE(fmt::format("{} {} K at {}", integrator, kelvin, beta));
        const PictureMean seen = glowing(
            kelvin, beta, "doppler = true\nbeaming = true\nintegrator = \"" + integrator + "\"");
        const Vec3 right = blackbody_rgb(kelvin, kelvin * head_on_doppler(beta));
        const double size = std::max({right.x, right.y, right.z});
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen.rgb[i] / size, right[i] / size, 4e-3);
      }
    }
  }
}

// Without `doppler` a temperature is a colour of luminance 1, whatever the velocity.
TEST(Doppler, IsNotNeededForTemperatures) {
  for (const std::string integrator : {"preview", "path"}) {
    for (const double kelvin : {1000.0, 2856.0, 30'000.0}) {
      const PictureMean seen = glowing(kelvin, 0.5, "integrator = \"" + integrator + "\"");
      const Vec3 right = blackbody_rgb(kelvin, kelvin);
      const double size = std::max({right.x, right.y, right.z});
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen.rgb[i] / size, right[i] / size, 1e-3);
    }
  }
}

// A mirror that comes at beta shifts what is behind the camera by D^2, and colours it by what it
// reflects where the light is shifted by D.
TEST(Doppler, MirrorsShiftTwiceAndReflectByTheLocalWavelength) {
  const Vec3 tint(0.9, 0.5, 0.2);
  for (const double beta : {0.0, 0.2, -0.3}) {
    const double d = head_on_doppler(beta);
    const std::string text =
        axis_camera("samples = 16\nintegrator = \"path\"\ndoppler = true\n") +
        square_object(beta, "mirror") +
        "[[object]]\nname = \"lamp\"\nasset = \"square.obj\"\nposition = [0, 0, 10]\nscale = 50\n"
        "rotation = [0, 180, 0]\nmaterial = \"lamp\"\n[[material]]\nname = \"lamp\"\nbase_color = "
        "\"black\"\nemission = \"white\"\n[[material]]\nname = \"mirror\"\nmetallic = 1\nroughness "
        "= 0\nbase_color = " +
        rgb_text(tint) + "\n";
    const PictureMean seen = mean_of(path_pictures(text, {kSquare})[0]);
    const Vec3 right = linear_from_xyz(
        shifted_xyz(d * d, [&](double w) { return daylight(w) * reflected(tint, w / d); }));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen.rgb[i], right[i], 4e-3) << beta;
  }
}

// What is seen straight is the same sum over wavelengths in both.
TEST(Doppler, PreviewAgrees) {
  const Vec3 rgb(0.8, 0.3, 0.1), glow(0.1, 0.2, 0.6);
  for (const double beta : {0.0, 0.4, -0.4}) {
    const auto render = [&](const std::string& integrator) {
      const std::string text =
          axis_camera("samples = 16\ndoppler = true\nintegrator = \"" + integrator + "\"") +
          square_object(beta) +
          fmt::format(
              "[[material]]\nname = \"patch\"\nunlit = true\nbase_color = {}\nemission = {}\n",
              rgb_text(rgb), rgb_text(glow));
      return mean_of(path_pictures(text, {kSquare})[0]);
    };
    const PictureMean preview = render("preview"), path = render("path");
    const Vec3 right = linear_from_xyz(shifted_xyz(
        head_on_doppler(beta), [&](double w) { return daylight(w) * reflected(rgb + glow, w); }));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(preview.rgb[i], right[i], 1e-3) << beta;
      EXPECT_NEAR(path.rgb[i], right[i], 1e-3 + 4 * path.error[i]) << beta;
    }
  }
}

}  // namespace
}  // namespace restframe

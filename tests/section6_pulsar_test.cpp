// Section 6 of the paper: a pulsar that runs away at 0.5c, turns once in 33 ms, and lights dust
// light-years away. Its beams' phase there has ten digits fewer than the distance, and must keep
// three: no precision may be lost on the way.

#include <gtest/gtest.h>

#include <numbers>

#include "support/shown_scene.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr long double turn = 0.033L;  // s
constexpr long double inner = 12 * pi / 180, outer = 34 * pi / 180;
constexpr int shell = 2, veil = 3;  // the scene's objects

const MovingLamp pulsar = {{-2e7L, 0, 0}, -44721359.55L, 2e6L, -0.5L};

// W/sr, in the flares and between them.
long double intensity(long double clock) {
  const long double phase = clock - 1.3e7L * std::floor(clock / 1.3e7L);
  return phase < 4e6L ? 7e16L : 2.5e15L;
}

// The cosine between the nearer beam and the way of the light; one beam shines along +x at clock 0.
long double beam_cosine(long double clock, const Long3& onward) {
  const long double turns = clock / turn;
  const Long3 beam = turned_about_y({1, 0, 0}, 2 * pi * (turns - std::floor(turns)));
  return std::abs(reference::dot(beam, onward));
}

// Green radiance where a beam shines fully on a matt surface at rest; 0 from behind.
long double full_radiance(const ShownPixel& pixel, const Long4& seen, const Emission& sent,
                          long double base) {
  const Long3 way = seen.x - sent.place;
  const long double distance = reference::length(way);
  const long double cosine = -reference::dot(way, pixel.normal) / distance;
  return std::max(0.0L, cosine) * 0.85L * intensity(sent.clock) / (distance * distance) * base / pi;
}

struct Phases {
  int measured = 0, unlit = 0;
  long double worst = 0;  // fraction of a turn
};

// On the slopes of the beams the brightness tells the phase.
Phases measured_phases(const ExrPicture& picture, const Long4& camera) {
  Phases phases;
  for (const ShownPixel& pixel : pixels_of(picture, veil)) {
    const Long3 at = pixel.at + Long3{-0.2L, -0.1L, 40000000.25L};
    const Long4 seen{camera.t - reference::length(at - camera.x), at};
    const Emission sent = emission_towards(pulsar, seen);
    const long double expected = beam_cosine(sent.clock, sent.onward);
    const long double ramp = spot_ramp(expected, inner, outer);
    const long double full = full_radiance(pixel, seen, sent, 0.15L);
    if (ramp < 0.05L || ramp > 0.95L || full < 0.002L) continue;
    const auto found = static_cast<long double>(pixel.color.y);
    if (found == 0) {
      ++phases.unlit;  // another fold of the veil is in the way
      continue;
    }
    const long double cosine =
        std::cos(outer) + std::sqrt(found / full) * (std::cos(inner) - std::cos(outer));
    const long double step = 1e-4L;
    const long double slope =
        (beam_cosine(sent.clock + step * turn, sent.onward) - expected) / step;
    phases.worst = std::max(phases.worst, std::abs((cosine - expected) / slope));
    ++phases.measured;
  }
  return phases;
}

void expect_exact(const Phases& phases) {
  EXPECT_GT(phases.measured, 300);
  EXPECT_LT(phases.unlit, phases.measured / 5);
  EXPECT_LT(phases.worst, 1e-4L);
}

// Rings that do not shine.
std::string pulsar_text() {
  return with_places(
      replaced(scene_text("pulsar"), "emission = [0.25, 0.45, 1.0]", "emission = [0, 0, 0]"));
}

TEST(Pulsar, IsFarAway) {
  const Emission sent = emission_towards(pulsar, {0, {0, 0, 4e7L}});
  const long double distance = reference::length(Long3{0, 0, 4e7L} - sent.place);
  EXPECT_GT(distance, 1.4L * 31557600);  // light-years
  EXPECT_NEAR(static_cast<double>(distance), static_cast<double>(-sent.time), 1e-8);
}

TEST(Pulsar, ItsPhaseOnDustLightYearsAwayIsExact) {
  const auto pictures = shown("pulsar", replaced(pulsar_text(), "pictures = 1\n", "pictures = 3\n"),
                              {"320x180", 1, 3});
  for (int i = 0; i < 3; ++i) {
    const Long4 camera{i / 240.0L, {0, 0, 4e7L}};
    expect_exact(measured_phases(pictures[static_cast<std::size_t>(i)], camera));
  }
}

// The same dust through a telescope that is almost a light-year away from it too.
TEST(Pulsar, ItsPhaseIsExactFromAfar) {
  std::string text =
      replaced(pulsar_text(), "position = [0, 0, 4e7]\n", "position = [2.7e7, 0, 3.1e7]\n");
  text = replaced(text, "direction = [-1, 0.05, -0.42]\n", "look_at = [-0.6, -0.1, 40000000.05]\n");
  text = replaced(text, "fov = 62\n", "fov = 1.2e-6\n");
  const auto pictures = shown("pulsar", text, {"320x180", 1, 1});
  expect_exact(measured_phases(pictures[0], {0, {2.7e7L, 0, 3.1e7L}}));
}

// Beams that do not turn and fill all directions: what is left are the flares, as rings that run
// over the shell.
TEST(Pulsar, FlaresAreLightEchoes) {
  std::string text = replaced(pulsar_text(), "sweep = {axis = [0, 1, 0], period = 0.033}\n", "");
  text = replaced(text, "cone = [12, 34]\n", "cone = [89, 90]\n");
  const auto pictures = shown("pulsar", text, {"320x180", 1, 1});
  const Long4 camera{0, {0, 0, 4e7L}};
  int bright = 0, dim = 0, changes = 0;
  bool was_bright = false;
  for (const ShownPixel& pixel : pixels_of(pictures[0], shell)) {
    const Long4 seen{camera.t - reference::length(pixel.at - camera.x), pixel.at};
    const Emission sent = emission_towards(pulsar, seen);
    const long double full = full_radiance(pixel, seen, sent, 0.5L);
    const long double mean = full / intensity(sent.clock);
    const bool near_edge = intensity(sent.clock - 2e4L) != intensity(sent.clock + 2e4L);
    // Not between the beams, nor in the rings' shadows.
    if (near_edge || std::abs(sent.onward.x) < 0.03L || std::abs(sent.onward.y) > 0.75L) continue;
    if (mean * 7e16L < 0.02L) continue;
    const auto found = static_cast<long double>(pixel.color.y);
    ASSERT_NEAR(static_cast<double>(found / full), 1, 0.02);
    const bool is_bright = full / mean > 5e16L;
    changes += is_bright != was_bright;
    was_bright = is_bright;
    (is_bright ? bright : dim) += 1;
  }
  EXPECT_GT(bright, 5000);
  EXPECT_GT(dim, 5000);
  EXPECT_GT(changes, 1000);  // along the picture's rows
}

}  // namespace
}  // namespace restframe

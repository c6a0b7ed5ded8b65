// Section 6 of the paper: the navigation radar of a fast ship, as the ship and as an observer at
// rest see it. All is computed in the rest frame of what the radar lights, in long double: when the
// lamp sent the light, whether it shone then, and where, and what was in the way.

#include <gtest/gtest.h>

#include <numbers>

#include "support/shown_scene.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr long double ship_speed = 0.5L;
constexpr long double ball_radius = 0.6L;
constexpr int plain = 2, beacons = 3;  // the scene's objects

// The radar lamp 0.6 below the ship's middle, which is at (-8, 4, 0) at `time`.
MovingLamp radar(long double time) {
  return {{-8, 3.4L, 0}, time, 0, ship_speed};
}

// The beacons' centres are 4 apart, up to `most_x` and `most_z` from the middle.
constexpr int most_x = 8, most_z = 5;

Long3 nearest_ball(const Long3& at) {
  const auto on_grid = [](long double v, int most) {
    return 4 * std::clamp(std::round(v / 4), -1.0L * most, 1.0L * most);
  };
  return {on_grid(at.x, most_x), 0.6L, on_grid(at.z, most_z)};
}

enum class Shade { lit, shadowed, unsure };

// Whether a way from above crosses a rod, which is 0.0001 thick.
bool meets_rod(const Long3& from, const Long3& way) {
  const Long3 at = from + ((0.6L - from.y) / way.y) * way;
  const auto near_line = [](long double v) { return std::abs(v - 4 * std::round(v / 4)) < 1e-3L; };
  return near_line(at.x) || near_line(at.z);
}

// Whether a ball is between two points.
Shade shade(const Long3& from, const Long3& to) {
  const Long3 way = to - from;
  if (meets_rod(from, way)) return Shade::unsure;
  const long double way_length = reference::length(way);
  const Long3 direction = way / way_length;
  Shade result = Shade::lit;
  for (int i = -most_x; i <= most_x; ++i) {
    for (int j = -most_z; j <= most_z; ++j) {
      const Long3 center{4.0L * i, 0.6L, 4.0L * j};
      const long double along = reference::dot(center - from, direction);
      if (along > way_length || along < 0) continue;
      const long double aside = reference::length(center - from - along * direction);
      if (std::abs(aside - ball_radius) < 0.01L) return Shade::unsure;
      if (aside < ball_radius) result = Shade::shadowed;
    }
  }
  return result;
}

struct Tally {
  int lit = 0, dark_between_pulses = 0, outside_beam = 0, shadowed = 0, near_a_pulse_edge = 0;
};

// Compares what a pixel shows with what the lamp sends there. seen: the event.
void check(const ShownPixel& pixel, const Long4& seen, const MovingLamp& lamp, Tally& tally) {
  const Emission sent = emission_towards(lamp, seen);
  const long double phase = sent.clock - std::floor(sent.clock);
  const long double from_edge =
      std::min({phase, 1 - phase, std::abs(phase - 0.3L)});  // of a pulse's begin or end
  if (from_edge < 1e-4L) return;
  const Long3 beam = turned_about_y(reference::normalized({1, -0.55L, 0}), 2 * pi * sent.clock / 6);
  const long double deg = pi / 180;
  const long double ramp = spot_ramp(reference::dot(beam, sent.onward), 26 * deg, 34 * deg);
  const Long3 way = seen.x - sent.place;
  const long double distance = reference::length(way);
  const long double cosine = -reference::dot(way, pixel.normal) / distance;
  if (std::abs(cosine) < 0.05L) return;

  const Shade in_way = shade(sent.place, seen.x);
  if (in_way == Shade::unsure) return;
  const double base = pixel.object == plain ? 0.27 : 0.75;
  const double full =
      static_cast<double>(600 * ramp * std::max(0.0L, cosine) / (distance * distance)) * base /
      static_cast<double>(pi);
  const bool on = phase < 0.3L;
  const double expected = on && in_way == Shade::lit ? full : 0;
  ASSERT_NEAR(pixel.color.y, expected, 0.02 * expected + 1e-5)
      << "clock " << static_cast<double>(sent.clock) << " at " << static_cast<double>(seen.x.x)
      << " " << static_cast<double>(seen.x.z);
  if (full < 1e-3) {
    tally.outside_beam += ramp == 0;
    return;
  }
  tally.lit += on && in_way == Shade::lit;
  tally.dark_between_pulses += !on && in_way == Shade::lit;
  tally.shadowed += on && in_way == Shade::shadowed;
  tally.near_a_pulse_edge += from_edge < 0.01L && in_way == Shade::lit;
}

// Only the radar shines.
std::string radar_only(const std::string& name) {
  const std::string text = replaced(scene_text(name), "intensity = 8\n", "intensity = 0\n");
  return with_places(replaced(text, "intensity = 0.25\n", "intensity = 0\n"));
}

// What a pixel sees of plain and balls, in the world; nothing of rods, ship and sky.
std::optional<Long3> place_of(const ShownPixel& pixel) {
  if (pixel.object == plain) return pixel.at;
  if (pixel.object != beacons) return std::nullopt;
  const Long3 at = pixel.at + Long3{0, 0.6L, 0};
  const long double radius = reference::length(at - nearest_ball(at));
  if (std::abs(radius - ball_radius) > 0.002L) return std::nullopt;
  return at;
}

void expect_all_seen(const Tally& tally) {
  EXPECT_GT(tally.lit, 500);
  EXPECT_GT(tally.dark_between_pulses, 500);
  EXPECT_GT(tally.outside_beam, 500);
  EXPECT_GT(tally.shadowed, 20);
  EXPECT_GT(tally.near_a_pulse_edge, 20);
}

TEST(Radar, AnObserverAtRestSeesEchoesAndShadowsWhenLightHasCome) {
  const auto pictures = shown("radar_rest", radar_only("radar_rest"), {"240x135", 1, 6});
  const Long3 camera{-1.5L, 30, 27};
  Tally tally;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (int object : {plain, beacons}) {
      for (const ShownPixel& pixel : pixels_of(pictures[i], object)) {
        const auto at = place_of(pixel);
        if (!at) continue;
        const long double time = 0.3L + static_cast<long double>(i);
        const Long4 seen{time - reference::length(*at - camera), *at};
        ASSERT_NO_FATAL_FAILURE(check(pixel, seen, radar(-40), tally)) << "picture " << i;
      }
    }
  }
  expect_all_seen(tally);
}

// The camera 2.4 behind the ship's middle and 1.6 above, at ship time tau.
Long4 ship_camera(long double tau) {
  const long double gamma = radar(0).gamma();
  return {gamma * (tau - ship_speed * 2.4L), {-8 + gamma * (-2.4L + ship_speed * tau), 5.6L, 0}};
}

TEST(Radar, TheShipSeesEchoesAndShadowsWhenLightHasCome) {
  const auto pictures = shown("radar_ship", radar_only("radar_ship"), {"240x135", 1, 6});
  Tally tally;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Long4 camera = ship_camera(12.3L + static_cast<long double>(i));
    for (int object : {plain, beacons}) {
      for (const ShownPixel& pixel : pixels_of(pictures[i], object)) {
        const auto at = place_of(pixel);
        if (!at) continue;
        const Long4 seen{camera.t - reference::length(*at - camera.x), *at};
        ASSERT_NO_FATAL_FAILURE(check(pixel, seen, radar(0), tally)) << "picture " << i;
      }
    }
  }
  expect_all_seen(tally);
}

// With the camera in the lamp's place (the ship does not hide what is below) an echo from r away, as
// the ship measures it when light is there, comes 2 r/c after its pulse, by the ship's clock.
TEST(Radar, TheShipSeesEchoesAfterTwiceTheDistance) {
  std::string text = replaced(radar_only("radar_ship"), "position = [-1.2, 0.8, 0]\n",
                              "position = [0, -0.3, 0]\n");
  text = replaced(text, R"(layers = ["beauty", "N", "P", "id"])",
                  R"(layers = ["beauty", "N", "P", "id", "Z"])");
  const auto pictures = shown("radar_ship", text, {"240x135", 1, 6});
  const MovingLamp lamp = radar(0);
  int on_time = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const ExrPicture& picture = pictures[i];
    const long double tau = 12.3L + static_cast<long double>(i);
    const Long4 camera{lamp.gamma() * tau,
                       lamp.place + Long3{lamp.gamma() * ship_speed * tau, 0, 0}};
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const ShownPixel pixel = pixel_at(picture, x, y);
        const auto at = place_of(pixel);
        if (!at) continue;
        const Long4 seen{camera.t - reference::length(*at - camera.x), *at};
        const Emission sent = emission_towards(lamp, seen);
        // Both ways are of light, in the world's frame.
        EXPECT_NEAR(static_cast<double>(reference::length(*at - sent.place)),
                    static_cast<double>(seen.t - sent.time), 1e-12);
        const long double r = 0.5L * (tau - sent.clock);
        ASSERT_NEAR(static_cast<double>(r), static_cast<double>(picture.at("Z", x, y)),
                    1e-5 * static_cast<double>(r));
        // A pulse of 0.3 s began when the clock was at a whole number.
        const long double sent_at = tau - 2 * static_cast<long double>(picture.at("Z", x, y));
        const long double phase = sent_at - std::floor(sent_at);
        if (!(pixel.color.y > 0)) continue;
        EXPECT_LT(phase, 0.301L);
        ++on_time;
      }
    }
  }
  EXPECT_GT(on_time, 500);
}

}  // namespace
}  // namespace restframe

// How lights reach a surface event, against closed forms 1, 7 and 13, computed in long double
// without src/physics.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/retarded_light.h"
#include "support/velocity_grid.h"
#include "tracer/light_sampling.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;
using reference::SeenLight;
using reference::widened;

constexpr double kLightSpeed = 3;  // scene lengths a second

// One lane of LitLanes and of IncidentLanes.
struct LitEvent {
  Event<in::World> event;
  Boost<in::Rest, in::World> rest_from_world;
  double omega = 1;
};
struct Incident {
  WaveVector<in::World> k;
  double s_light = 0;
  Vec3f direction{0}, irradiance{0};
};

// The odd lanes ask for something else, from another rest frame unless all rest in the world.
EventLanes<in::World> events_of(const LitEvent& event) {
  EventLanes<in::World> events;
  for (int i = 0; i < packet_size; ++i) {
    events.set(i, i % 2 == 0 ? event.event : Event<in::World>{4, {-7, 5, 3}});
  }
  return events;
}
LitLanes lanes_of(const LitEvent& event) {
  static const Boost<in::Rest, in::World> elsewhere(Velocity::from_beta({0.1, 0.2, -0.3}));
  LitLanes lit;
  lit.all_rest = event.rest_from_world.is_identity();
  for (int i = 0; i < packet_size; ++i) {
    lit.rest_from_world[i] = i % 2 == 0 || lit.all_rest ? &event.rest_from_world : &elsewhere;
    lit.omega[i] = i % 2 == 0 ? event.omega : 2.5;
    lit.active[i] = i == 4 ? 0 : -1;
  }
  return lit;
}

// A scene of one light, and what a surface event asks of it.
struct Lit {
  Scene scene;
  LitEvent event;
  Velocity surface;

  Light& light() { return scene.lights[0]; }
  std::optional<Incident> incident(bool beaming = false) const {
    TemporalEvaluator evaluator(scene.functions);
    IncidentLanes found;
    restframe::incident(light_places(scene)[0], events_of(event), lanes_of(event),
                        {kLightSpeed, beaming}, evaluator, found);
    EXPECT_EQ(found.active[4], 0);
    EXPECT_EQ(found.active[2], found.active[12]);
    constexpr int lane = 12;
    if (found.active[lane] == 0) return std::nullopt;
    return Incident{found.k.at(lane), found.s_light[lane], found.direction.at(lane),
                    found.irradiance.at(lane)};
  }
  // The surface asks for light of `omega` times the camera's frequency.
  void move_surface(const Velocity& velocity, double omega) {
    surface = velocity;
    event.rest_from_world = Boost<in::Rest, in::World>(velocity);
    event.omega = omega;
  }
};

Lit lit_by(LightKind kind, const Velocity& motion) {
  Lit lit;
  Light light;
  light.kind = kind;
  light.worldline = {{0.7, {1, -2, 0.5}}, motion};
  light.clock = 0.25;
  light.intensity.value = 5;
  lit.scene.lights = {light};
  lit.event.event = {0.3, {-0.5, 1.5, 2}};
  return lit;
}

SeenLight seen(const Lit& lit) {
  const Light& light = lit.scene.lights[0];
  const Event<in::World>& e = lit.event.event;
  return reference::seen(
      {widened(light.worldline.velocity.gamma_beta()), widened(light.worldline.reference.x),
       light.worldline.reference.t, light.clock},
      {e.t, widened(e.x)}, widened(lit.surface.gamma_beta()));
}

std::vector<Velocity> motions() {
  std::vector<Velocity> all = {Velocity()};
  for (const Vec3& direction : random_directions(3, 5)) {
    for (const double gamma : {1.0 + 1e-9, 1.2, 3.0, 30.0, 1000.0}) {
      all.push_back(Velocity::from_gamma(gamma, direction));
    }
  }
  all.push_back(Velocity::from_beta({0, 0, 0.9}));
  return all;
}

template <class Check>
void over_motions(LightKind kind, const Check& check) {
  for (const Velocity& of_light : motions()) {
    for (const Velocity& of_surface : motions()) {
      Lit lit = lit_by(kind, of_light);
      lit.move_surface(of_surface, 1.7);
      SCOPED_TRACE(::testing::Message()
                   << "light's gamma " << of_light.gamma() << ", surface's " << of_surface.gamma());
      check(lit);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

double relative(double value, long double expected) {
  return std::abs(value / static_cast<double>(expected) - 1);
}

double angle(const Vec3f& direction, const Long3& expected) {
  return static_cast<double>(reference::length(widened(Vec3(direction)) - expected));
}

// Closed form 13: E = D^4 I / r_surface^2 = D^2 I / r_light^2 with D from light to camera, and
// I / r_surface^2 without beaming.
TEST(PointLight, IrradianceIsClosedForm13) {
  over_motions(LightKind::point, [](const Lit& lit) {
    const SeenLight s = seen(lit);
    const long double r_surface = s.delay * s.at_surface * kLightSpeed;
    const long double r_light = s.delay * s.at_light * kLightSpeed;
    const long double d = s.at_surface / (s.at_light * lit.event.omega);
    const auto plain = lit.incident(false), beaming = lit.incident(true);
    ASSERT_TRUE(plain && beaming);
    EXPECT_LT(relative(plain->irradiance.x, 5 / (r_surface * r_surface)), 1e-5);
    EXPECT_LT(relative(beaming->irradiance.x, 5 * d * d * d * d / (r_surface * r_surface)), 1e-5);
    // Seen by a camera at rest on the surface: the other side of the closed form.
    Lit at_camera = lit;
    at_camera.event.omega = 1;
    const long double shift = s.at_surface / s.at_light;
    EXPECT_LT(
        relative(at_camera.incident(true)->irradiance.x, 5 * shift * shift / (r_light * r_light)),
        1e-5);
  });
}

TEST(PointLight, RayIsNullAndMeetsTheLightWithTheFrequencyKept) {
  over_motions(LightKind::point, [](const Lit& lit) {
    const SeenLight s = seen(lit);
    const auto found = lit.incident();
    ASSERT_TRUE(found);
    EXPECT_LT(std::abs(glm::length(found->k.x) / -found->k.t - 1), 1e-14);
    EXPECT_LT(relative(-lit.event.rest_from_world(found->k).t, lit.event.omega), 1e-12);
    EXPECT_LT(relative(found->s_light, s.delay * s.at_surface / lit.event.omega), 1e-8);
    const Event<in::World> there = point_on_ray(lit.event.event, found->k, found->s_light);
    const double size = static_cast<double>(s.delay) + 5;
    EXPECT_LT(std::abs(static_cast<double>(there.t - s.event.t)), 1e-8 * size);
    EXPECT_LT(glm::length(there.x - reference::narrowed(s.event.x)), 1e-8 * size);
    EXPECT_LT(angle(found->direction, s.sight_at_surface), 1e-6);
  });
}

TEST(PointLight, ShowsItsRetardedClock) {
  over_motions(LightKind::point, [](Lit& lit) {
    lit.scene.functions = {FormulaFunction{{"2 + sin(t)"}, {}, {}}};
    const SeenLight s = seen(lit);
    const float constant = lit.incident()->irradiance.x / 5;
    lit.light().intensity.function = 0;
    EXPECT_LT(relative(lit.incident()->irradiance.x / constant, 2 + std::sin(s.clock)), 1e-5);
  });
}

// The clock of the rest frame's own time is 0 at the world's origin event.
TEST(PointLight, FrameClockIsTheRestFramesTime) {
  Lit lit = lit_by(LightKind::point, Velocity::from_beta({0.3, -0.4, 0.7}));
  lit.light().frame_clock = true;
  lit.scene.functions = {FormulaFunction{{"t + 100"}, {}, {}}};
  const float constant = lit.incident()->irradiance.x / 5;
  lit.light().intensity.function = 0;
  const SeenLight s = seen(lit);
  const Long4 there = boosted(widened(lit.light().worldline.velocity.gamma_beta()), s.event);
  EXPECT_LT(relative(lit.incident()->irradiance.x / constant, there.t + 100), 1e-6);
}

TEST(PointLight, NothingComesFromTheLightsOwnEvent) {
  Lit lit = lit_by(LightKind::point, Velocity::from_beta({0, 0.5, 0}));
  lit.event.event = lit.light().worldline.reference;
  EXPECT_FALSE(lit.incident());
}

// As KHR_lights_punctual has it, in the light's rest frame.
TEST(SpotLight, ConesAreThoseOfTheLightsRestFrame) {
  int between = 0, dark = 0;
  over_motions(LightKind::spot, [&](Lit& lit) {
    const SeenLight s = seen(lit);
    const Long3 outwards = -1.0L * s.sight_at_light;
    // 0.5 rad from where the surface is.
    const Long3 across = normalized(cross(outwards, {0.3L, 0.5L, 0.8L}));
    lit.light().direction =
        reference::narrowed(std::cos(0.5L) * outwards + std::sin(0.5L) * across);
    for (const auto& [inner, outer] : {std::pair{0.6, 0.8}, {0.4, 0.7}, {0.1, 0.51}, {0.2, 0.49}}) {
      lit.light().inner_cone = inner;
      lit.light().outer_cone = outer;
      const double inside = std::clamp(
          (std::cos(0.5) - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
      const auto found = lit.incident();
      ASSERT_EQ(found.has_value(), inside > 0);
      dark += !found;
      if (!found) continue;
      between += inside < 1;
      const long double r = s.delay * s.at_surface * kLightSpeed;
      EXPECT_LT(relative(found->irradiance.x * static_cast<double>(r * r) / 5, inside * inside),
                1e-4);
    }
  });
  EXPECT_GT(between, 100);
  EXPECT_GT(dark, 100);
}

// A beam as narrow as a laser's is as bright in its middle as any, and falls off alike.
TEST(SpotLight, MayBeNarrow) {
  constexpr double inner = 1e-4, outer = 3e-4;
  for (const double off : {0.0, 0.5e-4, 1.5e-4, 2.5e-4, 3.1e-4}) {
    Lit lit = lit_by(LightKind::spot, Velocity::from_beta({0.3, 0.2, -0.6}));
    const Long3 outwards = -1.0L * seen(lit).sight_at_light;
    const Long3 across = normalized(cross(outwards, {0.3L, 0.5L, 0.8L}));
    const long double turned = off;
    lit.light().direction =
        reference::narrowed(std::cos(turned) * outwards + std::sin(turned) * across);
    lit.light().inner_cone = inner;
    lit.light().outer_cone = outer;
    const SeenLight s = seen(lit);
    const long double r = s.delay * s.at_surface * kLightSpeed;
    const double inside =
        std::clamp((outer * outer - off * off) / (outer * outer - inner * inner), 0.0, 1.0);
    const auto found = lit.incident();
    ASSERT_EQ(found.has_value(), inside > 0) << off;
    if (!found) continue;
    EXPECT_NEAR(found->irradiance.x * static_cast<double>(r * r) / 5, inside * inside, 1e-4) << off;
  }
}

// A beam that turns about z from x on is where its retarded clock has brought it.
TEST(SpotLight, SweepsByItsRetardedClock) {
  over_motions(LightKind::spot, [](Lit& lit) {
    Light& light = lit.light();
    light.direction = {1, 0, 0};
    light.sweep = Sweep{{0, 0, 1}, 0.7};
    light.inner_cone = 0;
    light.outer_cone = std::numbers::pi / 2;
    const SeenLight s = seen(lit);
    const long double turned = 2 * std::numbers::pi_v<long double> * s.clock / 0.7L;
    const double cosine =
        static_cast<double>(-dot(s.sight_at_light, {std::cos(turned), std::sin(turned), 0}));
    const auto found = lit.incident();
    ASSERT_EQ(found.has_value(), cosine > 0);
    if (!found) return;
    const long double r = s.delay * s.at_surface * kLightSpeed;
    EXPECT_NEAR(found->irradiance.x * static_cast<double>(r * r) / 5, cosine * cosine, 1e-4);
  });
}

// A point light far off, as bright at the sun's reference event's distance as the sun is.
TEST(Sun, IsTheLimitOfAFarPointLight) {
  constexpr double far = 1e9;
  for (const Velocity& of_light : motions()) {
    for (const Velocity& of_surface : motions()) {
      if (of_light.gamma() > 100) continue;  // there 1e9 is not far
      Lit sun = lit_by(LightKind::sun, of_light);
      sun.move_surface(of_surface, 0.6);
      sun.scene.functions = {FormulaFunction{{"2 + sin(t)"}, {}, {}}};
      sun.light().intensity.function = 0;
      const Vec3 direction = glm::normalize(Vec3(0.2, -1, 0.4));
      sun.light().direction = direction;
      Lit point = sun;
      point.light().kind = LightKind::point;
      // In the sun's rest frame: as far back, and as long before, so that the wavefronts agree.
      const AnchoredFrame<in::LightRest> frame{sun.light().worldline.reference,
                                               Boost<in::LightRest, in::World>(of_light)};
      point.light().worldline.reference = frame.to_world({-far, -far * direction});
      point.scene.functions = {FormulaFunction{{"9e18 * (2 + sin(t))"}, {}, {}}};
      const auto from_sun = sun.incident(true), from_point = point.incident(true);
      ASSERT_TRUE(from_sun && from_point);
      EXPECT_EQ(from_sun->s_light, std::numeric_limits<double>::infinity());
      EXPECT_LT(relative(from_sun->irradiance.x, from_point->irradiance.x), 1e-4)
          << of_light.gamma() << ' ' << of_surface.gamma();
      EXPECT_LT(glm::length(from_sun->direction - from_point->direction), 1e-4F);
      EXPECT_LT(glm::length(from_sun->k.x - from_point->k.x), 1e-4 * -from_sun->k.t);
    }
  }
}

// Radiance 1 in its own rest frame; D^4 where it beams, D = 1 / (gamma (1 + beta.e)).
TEST(Environment, BeamsByTheShiftOfTheRay) {
  for (const Velocity& motion : motions()) {
    Lit lit = lit_by(LightKind::environment, motion);
    lit.light().intensity.value = 1;
    TemporalEvaluator evaluator(lit.scene.functions);
    const LightPlace place = light_places(lit.scene)[0];
    for (const Vec3& e : random_directions(5, 8)) {
      const WaveVector<in::World> k{-0.4, 0.4 * e};
      const long double d =
          1 / (0.4L * frequency_seen_from(widened(motion.gamma_beta()), widened(e)));
      const Vec3f plain = environment_radiance(place, lit.event.event, k, false, evaluator);
      const Vec3f beaming = environment_radiance(place, lit.event.event, k, true, evaluator);
      EXPECT_EQ(plain, Vec3f(1));
      EXPECT_LT(relative(beaming.x, d * d * d * d), 1e-5) << motion.gamma();
    }
  }
}

}  // namespace
}  // namespace restframe

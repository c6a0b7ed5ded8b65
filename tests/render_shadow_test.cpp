// Retarded light and shadow on a floor, pixel by pixel: whether the straight null ray from a floor
// event to the light's retarded event is blocked by a moving sphere, how bright the floor is by
// closed form 13, and what a blinking screen lets through.

#include <gtest/gtest.h>

#include <cmath>

#include "support/path_scene.h"
#include "support/retarded_light.h"

namespace restframe {
namespace {

using reference::Long3;
using reference::Long4;

constexpr double kBase = 0.8, kIntensity = 30;

struct Motion {
  Vec3 position{0, 0, 0};
  Vec3 velocity{0, 0, 0};

  Long3 gamma_beta() const { return reference::widened(reference::gamma_beta_from_beta(velocity)); }
};

// A floor y = 0 that moves in its own plane, a sphere above it, a light above both.
struct Stage {
  Motion camera, floor, light, sphere;
  double radius = 0.5;
  bool beaming = false;
  Vec3 look{0, -1, -0.001};
  double fov = 60;
  int size = 100;

  reference::ObserverCamera observer() const {
    reference::ObserverCamera c;
    c.position = camera.position;
    c.gamma_beta = reference::gamma_beta_from_beta(camera.velocity);
    aim(c, glm::normalize(look), {0, 0, -1});
    c.vertical_fov = fov / 57.295779513082320877;
    c.width = c.height = size;
    return c;
  }
};

std::string object_text(const std::string& what, const Motion& motion,
                        const std::string& material) {
  return fmt::format("[[object]]\n{}\nposition = {}\nvelocity = {}\nmaterial = \"{}\"\n", what,
                     toml(motion.position), toml(motion.velocity), material);
}

std::string stage_text(const Stage& stage, const std::string& more) {
  return camera_text(stage.observer(),
                     fmt::format("samples = 1\ndepth = 1\nbeaming = {}", stage.beaming)) +
         object_text("asset = \"floor.obj\"", stage.floor, "floor") +
         fmt::format("[[light]]\ntype = \"point\"\nposition = {}\nvelocity = {}\nintensity = {}\n",
                     toml(stage.light.position), toml(stage.light.velocity), kIntensity) +
         more + diffuse_material("floor", kBase);
}

const AssetFile kFloor = {"floor.obj", quad_obj({0, 0, 0}, {0, 0, 500}, {500, 0, 0})};

// The floor's event at a film point, and the frequency there of light that the camera has at 1.
struct FloorEvent {
  Long4 event;
  long double omega = 1;
};

FloorEvent floor_event(const Stage& stage, const reference::FilmPoint& film) {
  const auto camera = stage.observer();
  const auto sight = world_sight(camera, direction_through(camera, film));
  const Long4 from = camera_event(camera, 0);
  const long double s = from.x.y / -sight.direction.y;
  return {{from.t - s, from.x + s * sight.direction},
          sight.frequency * frequency_seen_from(stage.floor.gamma_beta(), sight.direction)};
}

reference::SeenLight light_at(const Stage& stage, const Long4& event) {
  return seen({stage.light.gamma_beta(), reference::widened(stage.light.position), 0, 0}, event,
              stage.floor.gamma_beta());
}

// How near the ray from an event comes to the sphere's centre, in its rest frame, over its radius.
// The ray is a straight line there too.
long double nearness(const Stage& stage, const Long4& event, const Long3& sight,
                     long double length) {
  const Long3 u = stage.sphere.gamma_beta();
  const Long3 from = boosted(u, {event.t, event.x - reference::widened(stage.sphere.position)}).x;
  const Long3 along = boosted(u, {-1, sight}).x;
  const long double s = std::clamp(-dot(from, along) / dot(along, along), 0.0L, length);
  return reference::length(from + s * along) / stage.radius;
}

// Closed form 13 and Lambert's law: base / pi * E cos.
double lit_floor(const Stage& stage, const FloorEvent& at) {
  const reference::SeenLight s = light_at(stage, at.event);
  const long double r = s.delay * s.at_surface;
  const long double d = s.at_surface / (s.at_light * at.omega);
  const long double factor = stage.beaming ? d * d * d * d : 1;
  return static_cast<double>(kBase / 3.14159265358979323846L * kIntensity * factor *
                             s.sight_at_surface.y / (r * r));
}

enum class Expected { lit, dark, unsure };

// Unsure within a pixel of the shadow's outline, and where the sphere itself is seen.
Expected expected_at(const Stage& stage, int x, int y) {
  const auto camera = stage.observer();
  int dark = 0, lit = 0;
  for (const double dy : {-1.0, 0.0, 1.0}) {
    for (const double dx : {-1.0, 0.0, 1.0}) {
      const reference::FilmPoint film{x + 0.5 + dx, y + 0.5 + dy};
      const auto sight = world_sight(camera, direction_through(camera, film));
      if (nearness(stage, camera_event(camera, 0), sight.direction, 1e6L) < 1.02L)
        return Expected::unsure;
      const FloorEvent at = floor_event(stage, film);
      const reference::SeenLight s = light_at(stage, at.event);
      if (s.sight.y <= 0) return Expected::unsure;  // from below
      ++(nearness(stage, at.event, s.sight, s.delay) < 1 ? dark : lit);
    }
  }
  if (dark > 0 && lit > 0) return Expected::unsure;
  return dark > 0 ? Expected::dark : Expected::lit;
}

void expect_stage(const Stage& stage, int least_dark) {
  const std::string ball = object_text(
      fmt::format("sphere = {{radius = {}, fineness = 6}}", stage.radius), stage.sphere, "floor");
  const ExrPicture picture = path_pictures(stage_text(stage, ball), {kFloor})[0];
  int dark = 0, lit = 0;
  for (int y = 0; y < stage.size; ++y) {
    for (int x = 0; x < stage.size; ++x) {
      const Expected expected = expected_at(stage, x, y);
      const double value = static_cast<double>(picture.at("G", x, y));
      if (expected == Expected::dark) {
        ++dark;
        ASSERT_EQ(value, 0) << x << ", " << y;
      } else if (expected == Expected::lit) {
        ++lit;
        const double right = lit_floor(stage, floor_event(stage, {x + 0.5, y + 0.5}));
        ASSERT_NEAR(value, right, 1e-3 * right + 1e-6) << x << ", " << y;
      }
    }
  }
  EXPECT_GE(dark, least_dark);
  EXPECT_GT(lit, stage.size * stage.size / 3);
}

Stage still_stage() {
  Stage stage;
  stage.camera.position = {0.5, 7, 1};
  stage.light.position = {0, 4, 0};
  stage.sphere.position = {5, 1.8, 0};
  return stage;
}

TEST(Shadow, OfASphereAtRest) {
  Stage stage = still_stage();
  stage.sphere.position.x = 0.6;
  expect_stage(stage, 100);
}

// Puts the sphere where light on its way to what the camera sees at a film point meets it, at
// `height` above the floor.
void shade(Stage& stage, const reference::FilmPoint& film, double height) {
  const FloorEvent at = floor_event(stage, film);
  const reference::SeenLight s = light_at(stage, at.event);
  const long double way = height / s.sight.y;
  const Long3 place = at.event.x + way * s.sight;
  stage.sphere.position =
      reference::narrowed(place - (at.event.t - way) * reference::widened(stage.sphere.velocity));
}

// The shadow lags: it is where the sphere was when the light passed it.
TEST(Shadow, OfAFastSphereIsRetarded) {
  Stage stage = still_stage();
  for (const Vec3& velocity : {Vec3(0.9, 0, 0), Vec3(-0.7, 0.1, 0.4), Vec3(0, -0.6, 0.3)}) {
    stage.sphere.velocity = velocity;
    shade(stage, {40, 60}, 1.8);
    expect_stage(stage, 100);
    stage.beaming = !stage.beaming;
  }
}

TEST(Shadow, OfAFastLight) {
  Stage stage = still_stage();
  stage.sphere.velocity = {0.9, 0, 0};
  stage.light.velocity = {-0.8, 0, 0.3};
  stage.light.position = {-9, 4, 3};
  for (const bool beaming : {false, true}) {
    stage.beaming = beaming;
    shade(stage, {45, 60}, 1.5);
    expect_stage(stage, 100);
  }
}

TEST(Shadow, OnAMovingFloorSeenFromIt) {
  Stage stage = still_stage();
  stage.floor.velocity = stage.camera.velocity = {0.6, 0, 0.5};
  stage.sphere.velocity = {0.8, 0, 0.3};
  stage.light.velocity = {0.3, 0, 0.5};
  stage.light.position = {-2, 4, 1};
  for (const bool beaming : {false, true}) {
    stage.beaming = beaming;
    shade(stage, {60, 40}, 1.5);
    expect_stage(stage, 60);
  }
}

// Everything moves otherwise, and D counts all the way from the light to the camera.
TEST(Irradiance, IsClosedForm13AmongThreeVelocities) {
  Stage stage = still_stage();
  stage.sphere.position = {300, 3, 300};
  stage.floor.velocity = {-0.9, 0, 0.2};
  stage.camera.velocity = {0.1, 0.3, -0.6};
  stage.light.velocity = {0.5, 0.1, 0.7};
  stage.light.position = {2, 5, 5};
  stage.fov = 40;
  for (const bool beaming : {false, true}) {
    stage.beaming = beaming;
    expect_stage(stage, 0);
  }
}

// Tilted, so that floats round it: what lies near the middle of triangles 400 times as large.
TEST(Shadow, IsNotCastByALargeTriangleOnItself) {
  const Vec3 normal = glm::normalize(Vec3(0.3, 1, 0.2));
  const Vec3 u = glm::normalize(glm::cross(normal, Vec3(1, 0, 0)));
  const AssetFile slope = {"floor.obj",
                           quad_obj({0, 0, 0}, 400.0 * u, 400.0 * glm::cross(normal, u))};
  for (const char* opacity : {"1", "0.5"}) {
    Stage stage = still_stage();
    stage.camera.position = {0.5, 1.2, 1};
    const std::string text = object_text("sphere = {}", {{400, 900, 300}}, "far") +
                             fmt::format("[[material]]\nname = \"far\"\nopacity = {}\n", opacity);
    const ExrPicture picture = path_pictures(stage_text(stage, text), {slope})[0];
    for (int y = 0; y < stage.size; ++y) {
      for (int x = 0; x < stage.size; ++x) {
        const auto camera = stage.observer();
        const Vec3 sight = reference::narrowed(direction_through(camera, {x + 0.5, y + 0.5}));
        const double s = -glm::dot(camera.position, normal) / glm::dot(sight, normal);
        const Vec3 way = stage.light.position - (camera.position + s * sight);
        const double right = kBase / 3.14159265358979324 * kIntensity * glm::dot(way, normal) /
                             std::pow(glm::length(way), 3);
        ASSERT_NEAR(static_cast<double>(picture.at("G", x, y)), right, 1e-3 * right)
            << x << ", " << y << " opacity " << opacity;
      }
    }
  }
}

// Neither hides the light, whichever way shadows are looked for: with something in the scene that lets
// light pass, they are followed surface by surface.
TEST(Shadow, IsNotCastByTheSurfaceThatALightLiesOn) {
  const AssetFile ceiling = {"ceiling.obj", quad_obj({0, 0, 0}, {50, 0, 3}, {-3, 0, 50})};
  for (const Vec3& velocity : {Vec3(0, 0, 0), Vec3(0.7, 0, 0.3)}) {
    for (const char* opacity : {"1", "0.5"}) {
      Stage stage = still_stage();
      stage.camera.position = {0.5, 3.5, 0.4};
      stage.light.position = {0.3, 4, 0.1};
      stage.light.velocity = velocity;
      const std::string text =
          object_text("asset = \"ceiling.obj\"", {{0, 4, 0}, velocity}, "floor") +
          object_text("sphere = {}", {{400, 9, 300}}, "far") +
          fmt::format("[[material]]\nname = \"far\"\nopacity = {}\n", opacity);
      const ExrPicture picture = path_pictures(stage_text(stage, text), {kFloor, ceiling})[0];
      for (int y = 0; y < stage.size; ++y) {
        for (int x = 0; x < stage.size; ++x) {
          const double right = lit_floor(stage, floor_event(stage, {x + 0.5, y + 0.5}));
          ASSERT_NEAR(static_cast<double>(picture.at("G", x, y)), right, 1e-3 * right)
              << x << ", " << y << " opacity " << opacity;
        }
      }
    }
  }
}

// A screen between light and floor whose opacity blinks lets pass what its clock had it let pass
// when the light went through.
void expect_blinking_screen(const Vec3& velocity) {
  constexpr double height = 2, period = 0.9;
  Stage stage = still_stage();
  stage.camera.position = {0.5, 1.9, 0.4};
  stage.fov = 100;
  const Motion screen{{0.3, height, 0.1}, velocity};
  const std::string text =
      object_text("asset = \"floor.obj\"\nclock = 0.2", screen, "screen") +
      "[[material]]\nname = \"screen\"\nopacity = {period = 0.9, intervals = [[0, 0.45, 0.25], "
      "[0.45, 0.9, 1.0]]}\n";
  const ExrPicture picture = path_pictures(stage_text(stage, text), {kFloor})[0];
  int open = 0, closed = 0;
  for (int y = 0; y < stage.size; ++y) {
    for (int x = 0; x < stage.size; ++x) {
      const FloorEvent at = floor_event(stage, {x + 0.5, y + 0.5});
      const reference::SeenLight s = light_at(stage, at.event);
      const long double way = height / s.sight.y;
      const Long3 place = at.event.x + way * s.sight - reference::widened(screen.position);
      const long double clock = 0.2L + boosted(screen.gamma_beta(), {at.event.t - way, place}).t;
      const double phase = static_cast<double>(clock / period - std::floor(clock / period));
      if (std::min({phase, std::abs(phase - 0.5), 1 - phase}) < 1e-4) continue;
      ++(phase < 0.5 ? open : closed);
      const double right = phase < 0.5 ? 0.75 * lit_floor(stage, at) : 0;
      ASSERT_NEAR(static_cast<double>(picture.at("G", x, y)), right, 1e-3 * right + 1e-6)
          << x << ", " << y << " phase " << phase;
    }
  }
  EXPECT_GT(open, 1000);
  EXPECT_GT(closed, 1000);
}

TEST(Shadow, OfABlinkingScreenIsAsItsClockHadItThen) {
  expect_blinking_screen({0, 0, 0});
  expect_blinking_screen({0.8, 0, -0.1});
}

}  // namespace
}  // namespace restframe

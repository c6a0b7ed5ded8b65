// Motion vectors: where a point of an object is seen in the next picture, minus where it is seen now.
// Against long double, against the next picture itself, and against the closed form of what seems
// to move faster than light.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/animation.h"
#include "support/direct_render.h"
#include "support/loaded_scene.h"
#include "support/sphere_scene.h"

namespace restframe {
namespace {

using reference::FilmPoint;
using reference::MovingSphere;

constexpr double kInterval = 0.1;    // between pictures: the default rate
constexpr double kLongest = 60'000;  // of any vector

SphereScene small_scene() {
  SphereScene scene;
  scene.camera.width = 24;
  scene.camera.height = 16;
  scene.camera.vertical_fov = 0.8;
  scene.fineness = 3;
  scene.layers = R"(["P", "id", "motion"])";
  return scene;
}

// What a pixel of a scene of spheres shows.
struct Shown {
  int x = 0, y = 0;
  const MovingSphere* sphere = nullptr;  // null: nothing
  Vec3 point{0};                         // on it, light-seconds
  double u = 0, v = 0;
};

std::vector<Shown> shown_in(const SphereScene& scene, const Picture& picture) {
  const auto id = channel_of(picture, "id_object.V"), px = channel_of(picture, "P.X"),
             py = channel_of(picture, "P.Y"), pz = channel_of(picture, "P.Z"),
             u = channel_of(picture, "motion.U"), v = channel_of(picture, "motion.V");
  std::vector<Shown> all;
  for (std::size_t i = 0; i < id.size(); ++i) {
    Shown shown;
    shown.x = static_cast<int>(i) % scene.camera.width;
    shown.y = static_cast<int>(i) / scene.camera.width;
    if (id[i] > 0) shown.sphere = &scene.spheres[static_cast<std::size_t>(id[i]) - 1];
    shown.point = Vec3(px[i], py[i], pz[i]) / scene.light_speed;
    shown.u = u[i];
    shown.v = v[i];
    all.push_back(shown);
  }
  return all;
}

std::vector<Shown> shown_by(const SphereScene& scene, const std::string& text) {
  return shown_in(scene, first_picture(loaded_scene(text)));
}

// Fails where a motion is not that of long double's spheres. Returns how many points were seen.
int expect_motions(const SphereScene& scene) {
  int seen = 0;
  for (const Shown& shown : shown_by(scene, scene_file(scene))) {
    if (shown.sphere == nullptr) {
      EXPECT_EQ(shown.u, 0);
      EXPECT_EQ(shown.v, 0);
      continue;
    }
    const auto next = seen_point(*shown.sphere, shown.point, scene.camera, scene.start + kInterval);
    ++seen;
    if (!next.film) {
      EXPECT_NEAR(std::hypot(shown.u, shown.v), kLongest, 1);
      continue;
    }
    const double u = next.film->x - shown.x - 0.5, v = shown.y + 0.5 - next.film->y;
    const double length = std::hypot(u, v);
    if (length > kLongest) {
      EXPECT_NEAR(std::hypot(shown.u, shown.v), kLongest, 1);
      continue;
    }
    EXPECT_NEAR(shown.u, u, 2e-3 + 1e-4 * length) << shown.x << ' ' << shown.y;
    EXPECT_NEAR(shown.v, v, 2e-3 + 1e-4 * length) << shown.x << ' ' << shown.y;
  }
  return seen;
}

TEST(ApparentMotion, IsThatOfWhatPasses) {
  for (const double beta : {0.0, 0.5, 0.9, 0.99, 0.999}) {
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0.6, 0.8), Vec3(-0.6, 0, -0.8)}) {
      SCOPED_TRACE(fmt::format("{} {}", beta, toml(direction)));
      SphereScene scene = small_scene();
      scene.spheres.resize(1);
      scene.spheres[0].gamma_beta = reference::gamma_beta_from_beta(beta * direction);
      place_in_sight(scene.spheres[0], scene.camera, 0, {0, 0, -1}, 4);
      EXPECT_GT(expect_motions(scene), 20);
    }
  }
}

TEST(ApparentMotion, IsThatOfTheCameraToo) {
  SphereScene scene = small_scene();
  scene.light_speed = 7;
  scene.start = 3;
  scene.camera.gamma_beta = reference::gamma_beta_from_beta({0.5, 0.2, -0.6});
  scene.spheres.resize(2);
  scene.spheres[1].gamma_beta = reference::gamma_beta_from_beta({0, 0.7, 0.1});
  place_in_sight(scene.spheres[0], scene.camera, 3, glm::normalize(Vec3(-0.3, 0, -1)), 3);
  place_in_sight(scene.spheres[1], scene.camera, 3, glm::normalize(Vec3(0.4, 0.1, -1)), 5);
  EXPECT_GT(expect_motions(scene), 40);
}

// From one picture to the next it passes the camera, or the camera passes it: vectors stay finite.
TEST(ApparentMotion, OfWhatGetsBehindTheCameraIsAsLongAsCanBe) {
  SphereScene scene = small_scene();
  scene.spheres.resize(1);
  scene.spheres[0].radius = 0.01;
  scene.spheres[0].gamma_beta = reference::gamma_beta_from_beta({0, 0, 0.9});
  place_in_sight(scene.spheres[0], scene.camera, 0, glm::normalize(Vec3(0.3, 0.3, -1)), 0.1);
  const std::string text = scene_file(scene);
  int leaving = 0;
  for (const Shown& shown : shown_by(scene, text)) {
    if (shown.sphere == nullptr) continue;
    EXPECT_NEAR(std::hypot(shown.u, shown.v), kLongest, 1);
    EXPECT_GT(shown.u, 0);  // it leaves to the right and up
    EXPECT_GT(shown.v, 0);
    ++leaving;
  }
  EXPECT_GT(leaving, 3);
  expect_motions(scene);
}

// v sin / (1 - v cos) across the sight line, seven times as fast as light.
TEST(ApparentMotion, MayBeFasterThanLight) {
  const double beta = 0.99, cosine = beta, sine = std::sqrt(1 - beta * beta), far = 1000;
  SphereScene scene = small_scene();
  scene.camera.width = scene.camera.height = 31;
  scene.camera.vertical_fov = 0.02;
  scene.layers = R"(["Z", "P", "id", "motion"])";
  scene.spheres.resize(1);
  scene.spheres[0].radius = 0.5;
  scene.spheres[0].gamma_beta = reference::gamma_beta_from_beta(beta * Vec3(sine, 0, cosine));
  place_in_sight(scene.spheres[0], scene.camera, 0, {0, 0, -1}, far);
  const Shown middle = shown_by(scene, scene_file(scene))[15 * 31 + 15];
  ASSERT_NE(middle.sphere, nullptr);
  const double apparent = beta * sine / (1 - beta * cosine);
  EXPECT_NEAR(apparent, 7.02, 0.01);
  const double focal = 15.5 / std::tan(0.01);
  const double expected = apparent * kInterval / far * focal;
  EXPECT_NEAR(middle.u, expected, 0.01 * expected);
  EXPECT_NEAR(middle.v, 0, 0.01 * expected);
}

// The row in which it is seen next is exposed at that row's own time.
TEST(ApparentMotion, OfRollingShutters) {
  const double rolling = 0.05;
  SphereScene scene = small_scene();
  scene.spheres.resize(1);
  scene.spheres[0].gamma_beta = reference::gamma_beta_from_beta({0.3, -0.8, 0});
  place_in_sight(scene.spheres[0], scene.camera, 0, {0, 0, -1}, 4);
  std::string text = scene_file(scene);
  text.replace(text.find("[camera]\n"), 9, fmt::format("[camera]\nrolling = {}\n", rolling));
  int seen = 0;
  for (const Shown& shown : shown_by(scene, text)) {
    if (shown.sphere == nullptr) continue;
    const FilmPoint then{shown.x + 0.5 + shown.u, shown.y + 0.5 - shown.v};
    const double time = kInterval + rolling * then.y / scene.camera.height;
    const auto next = seen_point(*shown.sphere, shown.point, scene.camera, time);
    ASSERT_TRUE(next.film.has_value());
    EXPECT_NEAR(then.x, next.film->x, 2e-3);
    EXPECT_NEAR(then.y, next.film->y, 2e-3);
    ++seen;
  }
  EXPECT_GT(seen, 20);
}

// Each eye sees its own motion; films that are shifted are so in both pictures.
TEST(ApparentMotion, IsThatOfEachEye) {
  SphereScene scene = small_scene();
  scene.spheres.resize(1);
  scene.spheres[0].gamma_beta = reference::gamma_beta_from_beta({0.5, 0.3, 0.4});
  place_in_sight(scene.spheres[0], scene.camera, 0, {0, 0, -1}, 4);
  scene.more = "[camera.stereo]\nseparation = 0.6\nconvergence = 4\n";
  const Scene loaded = loaded_scene(scene_file(scene));
  const FrameSet frames(loaded, thread_count());
  const Integrator integrator = make_integrator(loaded, frames);
  EvaluatorPool evaluators(loaded.functions);
  for (const Eye eye : {Eye::left, Eye::right}) {
    Picture picture = blank_picture(loaded);
    render_picture({loaded, integrator, evaluators, {}}, 0, picture, eye);
    reference::ObserverCamera camera = scene.camera;
    camera.position.x = eye == Eye::left ? -0.3 : 0.3;
    int seen = 0;
    for (const Shown& shown : shown_in(scene, picture)) {
      if (shown.sphere == nullptr) continue;
      const auto now = seen_point(*shown.sphere, shown.point, camera, 0).film;
      const auto next = seen_point(*shown.sphere, shown.point, camera, kInterval).film;
      ASSERT_TRUE(now && next);
      EXPECT_NEAR(shown.u, next->x - now->x, 2e-3);
      EXPECT_NEAR(shown.v, now->y - next->y, 2e-3);
      ++seen;
    }
    EXPECT_GT(seen, 20);
  }
}

// Where pictures hold a value, between the pixels' centres.
struct Channels {
  const ExrPicture& picture;

  Vec3 point(double x, double y) const {
    const int left = static_cast<int>(std::floor(x - 0.5)),
              top = static_cast<int>(std::floor(y - 0.5));
    const double u = x - 0.5 - left, v = y - 0.5 - top;
    const auto at = [&](int i, int j) {
      return Vec3(picture.at("P.X", left + i, top + j), picture.at("P.Y", left + i, top + j),
                  picture.at("P.Z", left + i, top + j));
    };
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
  }
  // Whether all pixels around show the object.
  bool shows(float id, double x, double y) const {
    const int left = static_cast<int>(std::floor(x)) - 1, top = static_cast<int>(std::floor(y)) - 1;
    if (left < 0 || top < 0 || left + 2 >= picture.width || top + 2 >= picture.height) return false;
    for (int i = 0; i < 9; ++i) {
      if (picture.at("id_object.V", left + i % 3, top + i / 3) != id) return false;
    }
    return true;
  }
};

// What the next picture has where the vectors of the first lead to. Returns how many were followed.
int follow(const ExrPicture& first, const ExrPicture& second) {
  const Channels now{first}, next{second};
  int followed = 0;
  double moved = 0;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      const float id = first.at("id_object.V", x, y);
      const double u = static_cast<double>(first.at("motion.U", x, y)),
                   v = static_cast<double>(first.at("motion.V", x, y));
      const double to_x = x + 0.5 + u, to_y = y + 0.5 - v;
      if (id == 0 || !now.shows(id, x + 0.5, y + 0.5) || !next.shows(id, to_x, to_y)) continue;
      const Vec3 from = now.point(x + 0.5, y + 0.5);
      EXPECT_LT(glm::length(next.point(to_x, to_y) - from), 0.01) << x << ' ' << y;
      moved = std::max(moved, std::hypot(u, v));
      ++followed;
    }
  }
  EXPECT_GT(moved, 0.3);
  return followed;
}

// Square walls: their points are nearly even over the film.
std::string journey(const std::string& camera, const std::string& more = "") {
  return "[camera]\n" + camera +
         "[animation]\nrate = 4\npictures = 2\n[render]\nresolution = [64, 48]\nsamples = 2\n"
         "[output]\nlayers = [\"P\", \"id\", \"motion\"]\npreview = false\n" +
         more;
}

TEST(ApparentMotion, LeadsToTheSamePointOfTheNextPicture) {
  const std::string walls =
      "[[object]]\nname = \"still\"\nasset = \"wall.obj\"\nposition = [-1.2, 0, 0]\n"
      "[[object]]\nname = \"fast\"\nasset = \"wall.obj\"\nposition = [1, 0, -0.5]\nvelocity = "
      "[0.2, "
      "0.3, 0.3]\ntime = -4\n";
  const std::string kept = "position = [0.1, 0, 4]\nfov = 50\n";
  const std::vector<std::string> scenes = {
      journey(kept + "velocity = [0.3, 0.1, -0.2]\n", walls),
      journey(kept + "velocity = [0.3, 0.1, -0.2]\ntrack = \"fast\"\n", walls),
      journey(kept + "velocity = [0, 0.2, 0]\nlook_at = [0, 0.2, 0]\n", walls),
      journey("[[camera.key]]\ntime = 0\nposition = [0, 0, 4]\nfov = 50\nlook_at = [0, 0, 0]\n"
              "[[camera.key]]\ntime = 1\nposition = [0.6, 0.3, 3.6]\nfov = 40\nlook_at = [0.3, 0, "
              "0]\n",
              walls),
      journey(kept + "[[camera.leg]]\nduration = 1\nacceleration = [0.8, 0, -0.6]\n", walls),
      journey(kept + "velocity = [0.3, 0, 0]\naperture = 0.05\nfocus = 4\n",
              walls + "[exposure]\nshutter = 0.1\ncount = 2\ninterval = 0.05\n"),
      journey(kept + "velocity = [0.3, 0, 0]\n", walls + "[[light]]\ntype = \"environment\"\n"),
  };
  for (const std::string& text : scenes) {
    SCOPED_TRACE(text.substr(0, 300));
    const TemporaryFolder folder;
    folder.write("wall.obj", quad_obj({0, 0, 0}, {0.9, 0, 0}, {0, 0.9, 0}));
    const auto scene = folder.write("scene.toml", text);
    const RunResult result = run_program(
        RESTFRAME_PROGRAM,
        {"render", scene.string(), "--output", (folder.path() / "p.#.exr").string(), "--quiet"});
    ASSERT_EQ(result.exit_code, 0) << result.error;
    EXPECT_GT(follow(read_exr(folder.path() / "p.0.exr"), read_exr(folder.path() / "p.1.exr")),
              150);
  }
}

// The last picture's vectors lead to one that is never made; it must be one that could be.
TEST(ApparentMotion, NeedsACameraAfterTheLastPicture) {
  Scene scene = loaded_scene(
      "[animation]\nrate = 10\n[output]\nlayers = [\"P\"]\n[[object]]\nname = \"ball\"\nsphere = "
      "{}\nposition = [0, 0, -5]\n"
      "[[camera.key]]\ntime = 0\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\nfov = 50\n"
      "[[camera.key]]\ntime = 0.1\nposition = [0, 0, -1]\nlook_at = [0, 0, -1]\nfov = 50\n");
  EXPECT_THAT(validate(scene), testing::IsEmpty());
  scene.output.layers = {Layer::motion};
  EXPECT_THAT(
      validate(scene),
      testing::ElementsAre(testing::HasSubstr("picture 1: camera: it is at its look_at point")));
}

}  // namespace
}  // namespace restframe

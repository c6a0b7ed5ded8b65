// Assets in place of a scene file: their first camera and their lights.

#include <gtest/gtest.h>

#include <cmath>

#include "importers/importers.h"
#include "support/exr_reader.h"
#include "support/gltf_builder.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

const double half = std::sqrt(0.5);

// Turned by 90 degrees about y: the camera at (5, 1, 0) looks along -x, right is -z. The triangle,
// a thousandth in size, is at `place`, its front towards +x.
GltfBuilder spot_in_view(const Vec3& place) {
  GltfBuilder builder = test::one_triangle();
  builder.json["cameras"] = {{{"type", "orthographic"}, {"orthographic", json::object()}},
                             {{"type", "perspective"}, {"perspective", {{"yfov", 0.9}}}},
                             {{"type", "perspective"}, {"perspective", {{"yfov", 0.1}}}}};
  const json turned = {0, half, 0, half};
  builder.json["nodes"] = {{{"mesh", 0},
                            {"rotation", turned},
                            {"scale", {0.3, 0.3, 0.3}},
                            {"translation", {place.x, place.y, place.z}}},
                           {{"camera", 0}},
                           {{"rotation", turned}, {"translation", {4, 1, 0}}, {"children", {3}}},
                           {{"camera", 1}, {"translation", {0, 0, 1}}, {"scale", {3, 3, 3}}},
                           {{"camera", 2}}};
  builder.json["scenes"] = {{{"nodes", {0, 1, 2, 4}}}};
  return builder;
}

struct Seen {
  double x = 0, y = 0, nearest = 1e300;  // mean of the pixels that show something
  int count = 0;
};

Seen seen_in(const ExrPicture& picture) {
  Seen seen;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double z = picture.at("Z", x, y);
      if (!std::isfinite(z)) continue;
      seen.x += x + 0.5;
      seen.y += y + 0.5;
      seen.nearest = std::min(seen.nearest, z);
      ++seen.count;
    }
  }
  seen.x /= seen.count;
  seen.y /= seen.count;
  return seen;
}

// The child camera is at (4, 1, 0) + R (0, 0, 1) = (5, 1, 0). The centre of the triangle's corners
// is 0.1 (1, 1, 0) in its own axes, so at place + (0, 0.1, -0.1): turning takes x to -z.
TEST(AssetCamera, ShowsWhereThingsAreByClosedForm) {
  const TemporaryFolder folder;
  const Vec3 place(0, 2, 1);
  folder.write("a.glb", spot_in_view(place).glb());
  RunOptions options;
  options.folder = folder.path();
  const RunResult result = run_program(
      RESTFRAME_PROGRAM, {"render", "a.glb", "--size", "160x120", "--samples", "1"}, options);
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Seen seen = seen_in(read_exr(folder.path() / "out/a.0000.exr"));
  const Vec3 from_camera = place + Vec3(0, 0.1, -0.1) - Vec3(5, 1, 0);
  const double depth = -from_camera.x, right = -from_camera.z, up = from_camera.y;
  const double pixels = 60 / std::tan(0.45);  // of a tangent of 1
  ASSERT_GT(seen.count, 10);
  EXPECT_NEAR(seen.x, 80 + pixels * right / depth, 0.5);
  EXPECT_NEAR(seen.y, 60 - pixels * up / depth, 0.5);
  EXPECT_NEAR(seen.nearest, glm::length(from_camera), 0.3);
}

TEST(AssetCamera, IsTheFirstOfPerspective) {
  const TemporaryFolder folder;
  Warnings warnings;
  GltfBuilder builder = spot_in_view({0, 0, 0});
  const Scene scene = load_scene(folder.write("a.glb", builder.glb()), {}, warnings);
  EXPECT_TRUE(scene.camera_given);
  EXPECT_EQ(scene.camera.vertical_fov, 0.9);
  const CameraPose pose = pose_at(scene.camera, 0);
  EXPECT_EQ(pose.event.t, 0);
  EXPECT_LT(glm::length(pose.event.x - Vec3(5, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(pose.axes[0] - Vec3(0, 0, -1)), 1e-12);
  EXPECT_LT(glm::length(pose.axes[1] - Vec3(0, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(pose.axes[2] - Vec3(1, 0, 0)), 1e-12);
  builder.json["nodes"][3].erase("camera");
  builder.json["nodes"][4].erase("camera");
  EXPECT_FALSE(load_scene(folder.write("b.glb", builder.glb()), {}, warnings).camera_given);
}

// 68.3 lx are 0.1 W/m^2.
TEST(AssetCamera, LightsShineAsTheyArePlaced) {
  const TemporaryFolder folder;
  Warnings warnings;
  GltfBuilder builder = spot_in_view({0, 0, 0});
  builder.json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  builder.json["nodes"][2]["name"] = "sunshine";
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 68.3}}};
  const Scene scene = load_scene(folder.write("a.glb", builder.glb()), {}, warnings);
  ASSERT_EQ(scene.lights.size(), 1U);
  const Light& sun = scene.lights[0];
  EXPECT_EQ(sun.kind, LightKind::sun);
  EXPECT_FLOAT_EQ(sun.intensity.value, 0.1F);
  EXPECT_LT(glm::length(sun.direction - Vec3(-1, 0, 0)), 1e-12);
  EXPECT_EQ(sun.worldline.velocity, Velocity());
  EXPECT_TRUE(validate(scene).empty());
}

}  // namespace
}  // namespace restframe

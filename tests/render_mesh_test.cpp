// What meshes bring along: sides, mirrored placements, colours and textures at vertices, and flat
// faces without holes. The scenes are built here, without a file.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/generators.h"
#include "support/direct_render.h"

namespace restframe {
namespace {

// A square of half-width 1 across z = 0, its front towards +z; red grows with x, green with y.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.materials = {{0, 0}};
  mesh.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.colors = {{0, 0, 1, 1}, {1, 0, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 1}};
  pad_for_embree(mesh);
  return mesh;
}

// The square seen straight on from (0, 0, 2): it covers the picture. `copies` more of it lie out of
// sight, so that it is baked or instanced; 0: traversed alone.
Scene square_scene(const Mat4& placement, int copies = 0, bool other_mesh = false) {
  Scene scene;
  scene.meshes = {square()};
  if (other_mesh) scene.meshes.push_back(square());
  scene.materials.emplace_back();
  scene.materials[0].unlit = true;
  const auto add = [&](int mesh, const Mat4& object_from_mesh) {
    Object object;
    object.name = "square";
    object.parts = {{mesh, object_from_mesh}};
    object.materials = {0};
    scene.objects.push_back(object);
  };
  add(0, placement);
  for (int i = 0; i < copies; ++i) {
    add(other_mesh ? 1 : 0, glm::translate(Mat4(1), Vec3(0, 0, 50 + i)));
  }
  std::get<Worldline>(scene.camera.motion).reference.x = {0, 0, 2};
  scene.camera.vertical_fov = 2 * std::atan(0.5) * 0.98;
  scene.render.width = scene.render.height = 40;
  scene.render.samples = 1;
  scene.output.layers = {Layer::beauty, Layer::z, Layer::uv, Layer::normal, Layer::id};
  return scene;
}

double mean_alpha(const Scene& scene) {
  double sum = 0;
  const Picture picture = first_picture(scene);
  for (const Vec4f& pixel : picture.rgba()) sum += static_cast<double>(pixel.w);
  return sum / static_cast<double>(picture.rgba().size());
}

struct Placement {
  const char* what;
  Mat4 matrix;
  double front;  // 1 if its front faces the camera
};

// glTF: a mirroring placement turns the winding, so that what was the front stays the front.
std::vector<Placement> placements() {
  const Mat4 one(1);
  return {{"as it is", one, 1},
          {"mirrored across x", glm::scale(one, {-1, 1, 1}), 1},
          {"mirrored across y", glm::scale(one, {1, -1, 1}), 1},
          {"mirrored along the view", glm::scale(one, {1, 1, -1}), 0},
          {"turned by half", glm::rotate(one, glm::radians(180.0), {0, 1, 0}), 0},
          {"point-mirrored", glm::scale(one, Vec3(-1)), 0}};
}

// Each way to hold a mesh in a rest frame: alone, baked among others, as an instance.
TEST(Sides, BackFacesOfSingleSidedMaterialsAreNotSeen) {
  for (const Placement& placement : placements()) {
    SCOPED_TRACE(placement.what);
    EXPECT_EQ(mean_alpha(square_scene(placement.matrix)), placement.front);
    EXPECT_EQ(mean_alpha(square_scene(placement.matrix, 1, true)), placement.front);
    EXPECT_EQ(mean_alpha(square_scene(placement.matrix, 2)), placement.front);
    Scene both_sides = square_scene(placement.matrix);
    both_sides.materials[0].double_sided = true;
    EXPECT_EQ(mean_alpha(both_sides), 1);
  }
}

TEST(Sides, NormalsPointTowardsTheRay) {
  for (const Placement& placement : placements()) {
    for (int copies : {0, 2}) {
      Scene scene = square_scene(placement.matrix, copies);
      scene.materials[0].double_sided = true;
      for (const double z : channel_of(first_picture(scene), "N.Z")) ASSERT_NEAR(z, 1, 1e-6);
    }
  }
}

TEST(Vertices, ColoursAndTextureCoordinatesAreInterpolated) {
  for (int copies : {0, 2}) {
    const Scene scene = square_scene(Mat4(1), copies);
    const Picture picture = first_picture(scene);
    const auto u = channel_of(picture, "UV.U"), v = channel_of(picture, "UV.V");
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        const double half = std::tan(scene.camera.vertical_fov / 2) * 2;
        const double right = 0.5 * (1 + half * ((x + 0.5) / 20 - 1));
        const double up = 0.5 * (1 - half * ((y + 0.5) / 20 - 1));
        const std::size_t i = static_cast<std::size_t>(y * 40 + x);
        ASSERT_NEAR(u[i], right, 1e-5);
        ASSERT_NEAR(v[i], up, 1e-5);
        ASSERT_NEAR(picture.rgba()[i].x, right, 1e-5);
        ASSERT_NEAR(picture.rgba()[i].y, up, 1e-5);
      }
    }
  }
}

// A face that lies in a face of its bounds, wherever it is and however it moves.
TEST(FlatFaces, HaveNoHoles) {
  for (const Vec3& offset : {Vec3(0), Vec3(0.1, 0.2, 0.3), Vec3(-33.3, 71.7, 1e3)}) {
    for (double degrees : {0.0, 17.0, 60.0}) {
      for (const Vec3& beta : {Vec3(0), Vec3(0, 0, 0.9), Vec3(0.5, -0.3, 0.6)}) {
        Scene scene = square_scene(glm::rotate(Mat4(20.0), glm::radians(degrees), {1, 0.2, 0}));
        scene.objects[0].parts[0].object_from_mesh[3][3] = 1;
        scene.materials[0].double_sided = true;
        scene.camera.vertical_fov = 0.2;
        Worldline& line = scene.objects[0].worldline;
        line.velocity = Velocity::from_beta(beta);
        line.reference = {-2, offset};
        std::get<Worldline>(scene.camera.motion).reference.x = offset + Vec3(0, 0, 2);
        EXPECT_EQ(mean_alpha(scene), 1) << offset.x << ' ' << degrees << ' ' << beta.z;
      }
    }
  }
}

// A ball fills the picture, from within or from before it, whichever way its triangles' edges and
// the rays lie: alone, baked among others, or as an instance.
// It comes head-on, with this gamma, and is seen that much smaller. The camera is exactly on the
// axis, where the signs of directions change among the rays of one packet.
Scene ball_scene(int copies, double degrees, double gamma, bool within) {
  const Mat4 placement = glm::rotate(Mat4(1), glm::radians(degrees), {0, 0, 1});
  Scene scene = square_scene(placement, copies, copies == 1);
  scene.meshes[0] = make_ball({1.0, 5});
  scene.materials[0].double_sided = within;
  const Velocity velocity = Velocity::from_gamma(gamma, {0, 0, 1});
  for (Object& object : scene.objects) object.worldline.velocity = velocity;
  const AnchoredFrame<in::Rest> rest = scene.objects[0].worldline.rest_frame();
  std::get<Worldline>(scene.camera.motion).reference =
      rest.to_world({0, Vec3(0, 0, within ? 0 : 3)});
  scene.camera.up = {0.1, 0.9, 0};
  scene.camera.vertical_fov = (within ? 1.8 : 0.3) / (gamma + velocity.gamma_beta().z);
  // No multiple of four: packets of 4 x 4 pixels see both sides of the middle.
  scene.render.width = scene.render.height = 118;
  return scene;
}

TEST(ClosedSurfaces, HaveNoHoles) {
  for (const int copies : {0, 1, 2}) {
    for (const double degrees : {0.0, 30.0, 45.0}) {
      for (const double gamma : {1.0, 2.3, 20.0, 1000.0}) {
        for (const bool within : {false, true}) {
          EXPECT_EQ(mean_alpha(ball_scene(copies, degrees, gamma, within)), 1)
              << copies << ' ' << degrees << ' ' << gamma << ' ' << within;
        }
      }
    }
  }
}

TEST(Masks, CutAtTheCutoff) {
  Scene scene = square_scene(Mat4(1));
  scene.materials[0].alpha_mode = AlphaMode::mask;
  for (const auto& [opacity, seen] : {std::pair(0.49F, 0.0), {0.51F, 1.0}, {1.0F, 1.0}}) {
    scene.materials[0].opacity.value = opacity;
    EXPECT_EQ(mean_alpha(scene), seen);
  }
}

}  // namespace
}  // namespace restframe

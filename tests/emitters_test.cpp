// Which emitting triangles are chosen how often, and where on them.

#include "tracer/emitters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "scene/parallel.h"
#include "support/picture_statistics.h"
#include "support/solid_angles.h"
#include "support/velocity_grid.h"
#include "tracer/emitter_points.h"
#include "tracer/emitter_power.h"

namespace restframe {
namespace {

TEST(AliasTable, ChoosesByWeight) {
  const std::vector<double> weights = {0, 1, 5, 0.25, 0, 3, 1e-3, 7};
  const AliasTable table(weights);
  EXPECT_DOUBLE_EQ(table.total(), 16.251);
  std::vector<double> counts(weights.size());
  constexpr int steps = 4'000'000;
  for (int i = 0; i < steps; ++i) counts[table.choose((i + 0.5) / steps)] += 1.0 / steps;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(counts[i], weights[i] / table.total(), 3e-6) << i;
    EXPECT_NEAR(table.chance(i), weights[i] / table.total(), 1e-7);
  }
}

TEST(AliasTable, OfEqualWeightsChoosesEvenly) {
  const AliasTable table(std::vector<double>(1000, 0.1));
  for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(table.choose((i + 0.5) / 1000), i);
}

TEST(AliasTable, OfNothingHasNoChances) {
  const AliasTable table(std::vector<double>(3, 0.0));
  EXPECT_EQ(table.total(), 0);
  EXPECT_EQ(table.chance(1), 0);
}

// Two quads of two triangles, the second three times as large and half as bright; a dark one; one
// mesh is placed twice, mirrored and stretched, in an object that moves.
Scene scene_of_quads() {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {2, 0, 0}, {5, 0, 0}, {5, 1, 0}, {2, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {0, 1, 2}};
  mesh.materials = {{0, 0}, {2, 1}, {4, 2}};
  pad_for_embree(mesh);
  scene.meshes = {mesh};
  scene.materials.resize(3);
  scene.materials[0].emission.value = Vec3f(2);
  scene.materials[1].emission.value = Vec3f(1);
  Object resting, moving;
  resting.name = "resting";
  resting.parts = {{0, Mat4(1)}};
  resting.materials = {0, 1, 2};
  moving = resting;
  moving.name = "moving";
  moving.worldline.velocity = Velocity::from_beta({0, 0, 0.8});
  Mat4 mirrored(1);
  mirrored[0].x = -2;
  moving.parts.push_back({0, mirrored});
  scene.objects = {resting, moving};
  return scene;
}

// Calls visit(frame, part, triangle) for all of the scene of quads.
template <class Visit>
void for_each_triangle(const FrameSet& frames, const Visit& visit) {
  for (std::int32_t frame = 0; frame < static_cast<std::int32_t>(frames.frames().size()); ++frame) {
    for (std::uint32_t part = 0; part < frames.frame(frame).parts().size(); ++part) {
      for (std::uint32_t t = 0; t < 5; ++t) visit(frame, part, t);
    }
  }
}

TEST(Emitters, AreChosenByAreaTimesEmissionWithoutATree) {
  const Scene scene = scene_of_quads();
  const FrameSet frames(scene, 1);
  const Emitters emitters(scene, frames, 0);
  ASSERT_FALSE(emitters.empty());
  double sum = 0;
  for_each_triangle(frames, [&](std::int32_t frame, std::uint32_t part, std::uint32_t t) {
    const FramePart& placed = frames.frame(frame).part(part);
    const double chance = emitters.chance(frame, part, t, {{1, 2, 3}});
    const double power = t < 2 ? 2 : t < 4 ? 1 : 0;
    const double area = rest_triangle(scene, placed, t).area;
    // 2^(2/3) for the stretched one's 2: areas count on average over directions.
    const double counted = placed.rest_from_mesh[0].x < 0 ? area / 2 * std::cbrt(4.0) : area;
    EXPECT_NEAR(chance, power * counted / ((2 + std::cbrt(4.0)) * 5), 1e-7);
    sum += chance;
  });
  EXPECT_NEAR(sum, 1, 1e-6);
}

// From places all around, with and without a hierarchy: what is chosen has the chance that is told,
// no less often than that, and all chances of a frame are the frame's.
TEST(Emitters, TellTheChanceOfWhatTheyChoose) {
  const Scene scene = scene_of_quads();
  const FrameSet frames(scene, 1);
  for (const std::size_t most_leaves : {0, 100}) {
    const Emitters emitters(scene, frames, most_leaves);
    for (const Receiver& place :
         {Receiver{{0.3, 0.4, 2}}, Receiver{{4, -1, 0.2}}, Receiver{{-3, 0.5, 100}},
          Receiver{{0.3, 0.4, 2}, {0, 0, -1}}, Receiver{{2, -1, 0.5}, {0.6F, 0.8F, 0}}}) {
      std::map<std::tuple<std::int32_t, std::uint32_t, std::uint32_t>, double> counts;
      std::vector<double> of_frame(frames.frames().size());
      constexpr int steps = 200'000;
      for (int i = 0; i < steps; ++i) {
        const std::int32_t frame = emitters.choose_frame((i + 0.5) / steps);
        const auto chosen = emitters.choose(frame, place, std::fmod(i * 0.6180339887498949, 1.0));
        const EmittingPatch& patch = *chosen.patch;
        ASSERT_GT(chosen.chance, 0);
        ASSERT_NEAR(chosen.chance, emitters.chance(frame, patch.part, chosen.triangle, place),
                    1e-12);
        EXPECT_EQ(patch.frame, frame);
        counts[{frame, patch.part, chosen.triangle}] += 1.0 / steps;
        of_frame[static_cast<std::size_t>(frame)] += 1.0 / steps;
      }
      for_each_triangle(frames, [&](std::int32_t frame, std::uint32_t part, std::uint32_t t) {
        const double chance = emitters.chance(frame, part, t, place);
        EXPECT_NEAR((counts[{frame, part, t}]), chance, 1e-3);
        of_frame[static_cast<std::size_t>(frame)] -= chance;
      });
      for (const double left : of_frame) EXPECT_NEAR(left, 0, 1e-5);
    }
  }
}

// From behind all of them there is none to choose, unless backs shine, too.
TEST(Emitters, ThatFaceAwayAreNotChosen) {
  Scene scene = scene_of_quads();
  const FrameSet frames(scene, 1);
  const Emitters one_sided(scene, frames);
  EXPECT_EQ(one_sided.choose(0, {{0.5, 0.5, -2}}, 0.5).chance, 0);
  EXPECT_EQ(one_sided.chance(0, 0, 1, {{0.5, 0.5, -2}}), 0);
  for (Material& material : scene.materials) material.double_sided = true;
  const Emitters two_sided(scene, frames);
  EXPECT_GT(two_sided.choose(0, {{0.5, 0.5, -2}}, 0.5).chance, 0);
}

// Of a thousand equal triangles all over a room the near ones that face the place are preferred: the
// weights of what is chosen are much more even than by power.
TEST(EmitterTree, EvensOutWhatComesFromMany) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> number(-5, 5);
  std::vector<TreeLeaf> leaves;
  const std::vector<Vec3> normals = random_directions(1000, 8);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    TreeLeaf leaf;
    leaf.lower = {number(generator), number(generator), number(generator)};
    leaf.upper = leaf.lower + Vec3(0.05);
    leaf.normal = normals[i];
    leaf.power = 1;
    leaf.index = i;
    leaves.push_back(leaf);
  }
  const EmitterTree tree(leaves);
  double sum = 0, by_tree = 0, by_power = 0, chances = 0;
  const Vec3 place(0.3, -0.2, 0.1), facing(0, 0.6, -0.8);
  const Receiver receiver{place, Vec3f(facing)};
  for (const TreeLeaf& leaf : leaves) {
    const Vec3 away = place - 0.5 * (leaf.lower + leaf.upper);
    const double r = glm::length(away);
    const double comes = std::max(0.0, glm::dot(away, leaf.normal)) *
                         std::max(0.0, -glm::dot(away, facing)) / (r * r * r * r);
    const double chance = tree.chance(receiver, leaf.index);
    chances += chance;
    if (comes <= 0) continue;
    ASSERT_GT(chance, 0);
    sum += comes;
    by_tree += comes * comes / chance;
    by_power += comes * comes * 1000;
  }
  // Where neither half of a node can face the place after all, nothing is chosen.
  EXPECT_LT(chances, 1 + 1e-6);
  EXPECT_GT(chances, 0.5);
  EXPECT_LT(by_tree - sum * sum, 0.2 * (by_power - sum * sum));
}

TEST(Emitters, FaceTheFrontHoweverTheyArePlaced) {
  const Scene scene = scene_of_quads();
  const FrameSet frames(scene, 1);
  for (const RestFrame& frame : frames.frames()) {
    for (const FramePart& part : frame.parts()) {
      EXPECT_NEAR(rest_triangle(scene, part, 0).normal.z, 1, 1e-12);
    }
  }
}

TEST(Emitters, AreNoneWhereNothingShines) {
  Scene scene = scene_of_quads();
  scene.materials.assign(3, Material());
  const FrameSet frames(scene, 1);
  EXPECT_TRUE(Emitters(scene, frames).empty());
}

// A light that flashes for a thousandth of its time, at a time that no grid meets.
TEST(Emitters, CountWhatSeldomShines) {
  Scene scene = scene_of_quads();
  scene.functions = {IntervalFunction{1.0, {{0.12345, 0.12346, Vec3f(5)}}},
                     KeyFunction{{}, {{3, Vec3f(0)}, {3.001, Vec3f(9)}, {3.002, Vec3f(0)}}},
                     FormulaFunction{{"t > 1000"}, {}, {}}};
  for (int function = 0; function < 3; ++function) {
    Material material;
    material.emission.value = Vec3f(1);
    material.emission_strength = {0.0F, function};
    TemporalEvaluator evaluator(scene.functions);
    EXPECT_TRUE(emits(material));
    EXPECT_GT(emitted_power(scene, material, evaluator).emission, 0) << function;
  }
}

TEST(Emitters, KnowWhereTheirTexturesAreBright) {
  Scene scene = scene_of_quads();
  Image image{"half", 8, 1, std::vector<std::uint8_t>(32, 0)};
  for (int i = 16; i < 32; ++i) image.rgba[static_cast<std::size_t>(i)] = 255;
  scene.images = {image};
  scene.textures.resize(1);
  Mesh& mesh = scene.meshes[0];
  mesh.uvs[0].assign(mesh.positions.size(), Vec2f(0.2F, 0.5F));
  for (std::size_t i = 4; i < 8; ++i) mesh.uvs[0][i] = Vec2f(0.8F, 0.5F);
  Material material;
  material.emission.value = Vec3f(1);
  material.emission_texture.texture = 0;
  const std::vector<double> powers = triangle_powers(scene, mesh, 0, 4, material, {1, 0});
  EXPECT_NEAR(powers[2], 1.5, 1e-6);
  EXPECT_NEAR(powers[0], 0.5 * 0.1 * 0.5, 1e-6);  // dark, but samples might have missed something
}

// Points of a moving emitter as a moving surface sees them: 1 / density over those that are chosen
// estimates the solid angle of each part of its sphere that the emitter covers. Told by a sphere
// around the surface's event, which covers all of it, whatever its velocity: 4 pi.
class SeenPoints : public ::testing::TestWithParam<Vec3> {};

Scene sphere_around(const Vec3& velocity) {
  Scene scene;
  Mesh mesh;
  constexpr int rows = 24, columns = 48;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double theta = 3.14159265358979 * i / rows, phi = 2 * 3.14159265358979 * j / columns;
      mesh.positions.emplace_back(10 * std::sin(theta) * std::cos(phi), 10 * std::cos(theta),
                                  10 * std::sin(theta) * std::sin(phi));
    }
  }
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t a = i * columns + j, b = i * columns + (j + 1) % columns;
      mesh.triangles.push_back({a, b, b + columns});
      mesh.triangles.push_back({a, b + columns, a + columns});
    }
  }
  mesh.materials = {{0, 0}};
  pad_for_embree(mesh);
  scene.meshes = {mesh};
  scene.materials.resize(1);
  scene.materials[0].emission.value = Vec3f(1);
  scene.materials[0].double_sided = true;
  Object object;
  object.name = "sphere";
  object.parts = {{0, Mat4(1)}};
  object.materials = {0};
  object.worldline = {{0.3, {1, 2, -1}}, Velocity::from_beta(velocity)};
  scene.objects = {object};
  return scene;
}

TEST_P(SeenPoints, HaveDensitiesOfTheSurfacesFrame) {
  const Scene scene = sphere_around(GetParam());
  const FrameSet frames(scene, 1);
  const Emitters emitters(scene, frames);
  const EmitterStage stage{scene, frames, emitters};
  const Boost<in::Rest, in::World> surface(Velocity::from_beta({-0.3, 0.5, 0.1}));
  LitLanes lit;
  lit.rest_from_world.fill(&surface);
  lit.omega.fill(0.8);
  lit.active.fill(-1);
  EventLanes<in::World> event;
  Vec3fLanes all_around;
  for (int i = 0; i < packet_size; ++i) {
    event.set(i, {0.3, {1.5, 1.5, -0.5}});
    all_around.set(i, Vec3f(0));
  }
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<float> number(0, 1);
  constexpr int packets = 4000, parts = 8;
  SolidAngles angles(parts);
  for (int p = 0; p < packets; ++p) {
    PointNumbers numbers;
    for (int i = 0; i < packet_size; ++i) {
      numbers.frame[i] = number(generator);
      numbers.triangle[i] = static_cast<double>(number(generator));
      numbers.u[i] = number(generator);
      numbers.v[i] = number(generator);
    }
    EmitterPoints points;
    choose_points(stage, event, lit, all_around, numbers, points);
    PointsSeen seen;
    IncidentLanes incident;
    see_points(stage, event, lit, points, seen, incident);
    for (int i = 0; i < packet_size; ++i) {
      if (incident.active[i] == 0) continue;
      const Vec3f d = incident.direction.at(i);
      const std::size_t octant = (d.x < 0 ? 1U : 0U) + (d.y < 0 ? 2U : 0U) + (d.z < 0 ? 4U : 0U);
      angles.add(octant, seen.density[i]);
    }
  }
  angles.expect_equal(packets * packet_size, sidak_bound(3 * parts));
}

INSTANTIATE_TEST_SUITE_P(At, SeenPoints,
                         ::testing::Values(Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.2, -0.3, 0.8)));

}  // namespace
}  // namespace restframe

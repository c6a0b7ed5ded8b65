// scenes/clocks: clocks that agree in their own frame, read from the pictures by their hands.

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "support/animation.h"
#include "support/figure.h"
#include "support/shown_scene.h"

namespace restframe {
namespace {

constexpr int kWidth = 1280, kHeight = 360, kRow = 7;

// The hands, 0 to 11, that each object shows; the first object is 1.
std::vector<std::set<int>> hands_of(const ExrPicture& picture, std::size_t objects) {
  std::vector<std::string> materials;
  std::istringstream names(picture.attributes.at("materialNames"));
  for (std::string name; std::getline(names, name);) materials.push_back(name);
  std::vector<std::set<int>> hands(objects + 1);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto object = static_cast<std::size_t>(picture.at("id_object.V", x, y));
      if (object == 0) continue;
      const auto material = static_cast<std::size_t>(picture.at("id_material.V", x, y));
      const std::string& name = materials.at(material - 1);
      if (name.rfind("hand_", 0) == 0) hands[object].insert(std::stoi(name.substr(5)));
    }
  }
  return hands;
}

// What a clock shows that is set by its rest frame's time: gamma (t - beta x), where and when closed
// form 1 sees it.
double reading(const Scene& scene, std::size_t object, double time) {
  reference::MovingSphere dial;
  const Worldline& line = scene.objects[object].worldline;
  dial.gamma_beta = line.velocity.gamma_beta();
  dial.center = line.reference.x;
  dial.time = line.reference.t;
  dial.clock = line.velocity.gamma() * dial.time - dial.gamma_beta.x * dial.center.x;
  const double clock = reference::seen_point(dial, {0, 0, 0}, figure_camera(scene), time).clock;
  return clock - 12 * std::floor(clock / 12);
}

TEST(Clocks, FlyingOnesAreOutOfStepByOneSecondEach) {
  const auto folder = folder_of_scene("clocks");
  const std::string text =
      replaced(small(scene_text("clocks"), kWidth, kHeight, R"(["beauty", "id"])"), "dial.obj",
               (folder / "dial.obj").string());
  const Scene scene = figure_scene(text);
  ASSERT_EQ(scene.objects.size(), 2U * kRow);
  const auto pictures = rendered_animation(RESTFRAME_PROGRAM, text, scene.animation.pictures);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double time = scene.animation.start + static_cast<double>(i) / scene.animation.rate;
    const auto hands = hands_of(pictures[i], scene.objects.size());
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
      const int expected = static_cast<int>(reading(scene, k, time));
      EXPECT_EQ(hands[k + 1], std::set<int>{expected}) << i << ' ' << scene.objects[k].name;
      if (k % kRow == 0) continue;
      // The one ahead is behind, by a second; at rest they agree.
      const int before = *hands[k].begin(), here = *hands[k + 1].begin();
      EXPECT_EQ((before - here + 12) % 12, k < kRow ? 1 : 0) << i << ' ' << scene.objects[k].name;
    }
  }
}

}  // namespace
}  // namespace restframe

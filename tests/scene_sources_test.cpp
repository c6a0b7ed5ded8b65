// The files that went into a scene.

#include <gmock/gmock.h>

#include "support/gltf_builder.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;

class SceneSources : public SceneReading {};

TEST_F(SceneSources, AreListedWithTheirHashes) {
  const std::string text =
      "[[object]]\nasset = \"paint.obj\"\n[[material]]\nname = \"paint\"\n"
      "opacity = {file = \"fade.txt\"}\n";
  folder.write("fade.txt", "% period 2\n% interval 0 1 0.5\n");
  const Scene scene = read(text);
  std::vector<std::string> names;
  for (const SourceFile& source : scene.sources) {
    names.push_back(source.name);
    EXPECT_EQ(source.hash.size(), 32U);
  }
  EXPECT_THAT(names, ElementsAre("scene.toml", "paint.obj", "paint.mtl", "fade.txt"));
  folder.write("paint.mtl", "newmtl paint\nKd 1 0 1\n");
  const Scene changed = read(text);
  EXPECT_EQ(changed.sources[1].hash, scene.sources[1].hash);
  EXPECT_NE(changed.sources[2].hash, scene.sources[2].hash);
}

TEST_F(SceneSources, OfAGltfAreTheFilesThatWereRead) {
  const test::GltfBuilder triangle = test::one_triangle();
  folder.write("sub/a.gltf", triangle.gltf("data/one%20triangle.bin"));
  folder.write("sub/data/one triangle.bin", triangle.bin);
  folder.write("sub/data/other.bin", triangle.bin);
  const Scene scene = read("[[object]]\nasset = \"sub/a.gltf\"\n");
  std::vector<std::string> names;
  for (const SourceFile& source : scene.sources) names.push_back(source.name);
  EXPECT_THAT(names, ElementsAre("scene.toml", "sub/a.gltf", "sub/data/one triangle.bin"));
}

}  // namespace
}  // namespace restframe

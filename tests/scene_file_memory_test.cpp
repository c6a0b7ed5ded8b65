// Many objects that place one large asset.

#include <gmock/gmock.h>

#include "support/gltf_builder.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

using test::GltfBuilder;

constexpr std::size_t nodes = 300;

class SceneFileMemory : public SceneReading {
 protected:
  SceneFileMemory() {
    GltfBuilder builder = test::one_triangle();
    for (std::size_t i = 1; i < nodes; ++i) builder.add("nodes", {{"mesh", 0}});
    builder.json["nodes"][5]["name"] = "one";
    folder.write("many.glb", builder.glb());
  }

  Scene read_objects(int count, std::size_t bytes, const std::string& keys = "") {
    std::string text;
    for (int i = 0; i < count; ++i) text += "[[object]]\nasset = \"many.glb\"\n" + keys;
    ImportLimits limits;
    limits.total_bytes = bytes;
    return load_scene(folder.write("scene.toml", text), limits, warnings);
  }
};

// Room for the lists of three objects, and half of the fourth's.
constexpr std::size_t three_and_a_half = nodes * sizeof(PlacedMesh) * 7 / 2;

TEST_F(SceneFileMemory, ListsOfObjectsHaveALimit) {
  EXPECT_EQ(read_objects(3, three_and_a_half).objects.at(2).parts.size(), nodes);
  try {
    read_objects(6, three_and_a_half);
    FAIL();
  } catch (const InputError& error) {
    const std::string file = (folder.path() / "scene.toml").string();
    EXPECT_EQ(error.what(),
              file +
                  ":7:1: object \"object_4\": places 300 of its asset's meshes: the lists of all "
                  "objects up to this one need more than " +
                  std::to_string(three_and_a_half) + " bytes, the limit; --max-bytes raises it");
  }
}

TEST_F(SceneFileMemory, OnlyWhatObjectsPlaceCounts) {
  EXPECT_EQ(read_objects(20, three_and_a_half, "node = \"one\"\n").objects.size(), 20U);
}

}  // namespace
}  // namespace restframe

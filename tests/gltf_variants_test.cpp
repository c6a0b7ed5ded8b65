// KHR_materials_variants: the looks that an asset comes in, chosen by name.

#include <gtest/gtest.h>

#include <fstream>

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"
#include "support/program.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

constexpr const char* extension = "KHR_materials_variants";

json mapped(const json& mappings) {
  return {{extension, {{"mappings", mappings}}}};
}

// A mesh of four primitives: always "sole"; a red "upper" that is blue by night and at sea; one that
// is the same as the first but for the sea; and one without a material but by night.
GltfBuilder shoe() {
  GltfBuilder builder = test::one_triangle();
  json& primitives = builder.json["meshes"][0]["primitives"];
  const json bare = primitives[0];
  for (const char* name : {"sole", "red", "blue", "wet"})
    builder.add("materials", {{"name", name}});
  for (int i = 1; i < 4; ++i) primitives.push_back(bare);
  primitives[0]["material"] = 0;
  primitives[1]["material"] = 1;
  primitives[1]["extensions"] = mapped({{{"material", 2}, {"variants", {1, 2}}}});
  primitives[2]["material"] = 0;
  primitives[2]["extensions"] =
      mapped({{{"material", 3}, {"variants", {2}}}, {{"material", 0}, {"variants", {0}}}});
  primitives[3]["extensions"] = mapped({{{"material", 2}, {"variants", {1}}}});
  builder.json["extensions"][extension]["variants"] = {
      {{"name", "day"}}, {{"name", "night"}}, {{"name", "sea"}}};
  builder.json["extensionsRequired"] = {extension};
  return builder;
}

class Variants : public testing::Test {
 protected:
  Variants() { folder_.write("shoe.glb", shoe().glb()); }

  Scene read(const std::string& scene) {
    return load_scene(folder_.write("scene.toml", scene), {}, warnings_);
  }
  Scene read_asset(const std::optional<std::string>& variant) {
    return load_scene(folder_.path() / "shoe.glb", {}, warnings_, variant);
  }
  std::string fault(const std::string& scene) {
    try {
      read(scene);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  // The names of the materials of an object's triangles.
  static std::vector<std::string> looks(const Scene& scene, std::size_t object = 0) {
    std::vector<std::string> names;
    const Object& o = scene.objects.at(object);
    const Mesh& mesh = scene.meshes.at(static_cast<std::size_t>(o.parts.at(0).mesh));
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const int material = o.materials.at(static_cast<std::size_t>(material_slot(mesh, t)));
      names.push_back(scene.materials.at(static_cast<std::size_t>(material)).name);
    }
    return names;
  }

  using Looks = std::vector<std::string>;
  const std::string asset_ = "[[object]]\nasset = \"shoe.glb\"\n";
  TemporaryFolder folder_;
  Warnings warnings_;
};

TEST_F(Variants, OfAnAssetThatStandsInForAScene) {
  EXPECT_EQ(looks(read_asset({})), (Looks{"sole", "red", "sole", "default"}));
  EXPECT_EQ(looks(read_asset("day")), (Looks{"sole", "red", "sole", "default"}));
  EXPECT_EQ(looks(read_asset("night")), (Looks{"sole", "blue", "sole", "blue"}));
  EXPECT_EQ(looks(read_asset("sea")), (Looks{"sole", "blue", "wet", "default"}));
  EXPECT_EQ(warnings_, Warnings{});
}

TEST_F(Variants, OfObjectsThatShareAnAsset) {
  const Scene scene =
      read(asset_ + "variant = \"night\"\n" + asset_ + asset_ + "variant = \"sea\"\n");
  EXPECT_EQ(looks(scene, 0), (Looks{"sole", "blue", "sole", "blue"}));
  EXPECT_EQ(looks(scene, 1), (Looks{"sole", "red", "sole", "default"}));
  EXPECT_EQ(looks(scene, 2), (Looks{"sole", "blue", "wet", "default"}));
  EXPECT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.materials.size(), 5U);  // each once
}

// A change of a material holds wherever the variant shows it.
TEST_F(Variants, ChangesFollowWhatIsShown) {
  const Scene scene = read(asset_ + "variant = \"night\"\n[[material]]\nname = \"blue\"\n" +
                           "base_color = [0, 0, 0.5]\n");
  const Object& object = scene.objects.at(0);
  const Mesh& mesh = scene.meshes.at(0);
  const auto color = [&](std::uint32_t triangle) {
    const int material =
        object.materials.at(static_cast<std::size_t>(material_slot(mesh, triangle)));
    return scene.materials.at(static_cast<std::size_t>(material)).base_color.value;
  };
  EXPECT_EQ(color(0), Vec3f(1));
  EXPECT_EQ(color(1), Vec3f(0, 0, 0.5F));
  EXPECT_EQ(color(3), Vec3f(0, 0, 0.5F));
  const Scene replaced = read(asset_ + "variant = \"sea\"\nmaterials = {wet = \"red\"}\n");
  EXPECT_EQ(looks(replaced), (Looks{"sole", "blue", "red", "default"}));
}

TEST_F(Variants, UnknownOnesAreNamed) {
  const std::string at = (folder_.path() / "scene.toml").string() + ":3:11: object \"object_1\": ";
  EXPECT_EQ(fault(asset_ + "variant = \"nigth\"\n"),
            at + "the asset has no variant \"nigth\", the nearest is \"night\"");
  EXPECT_EQ(fault("[[object]]\nsphere = {}\nvariant = \"day\"\n"),
            at + "variant \"day\": the asset has no variants");
  EXPECT_EQ(fault(asset_ + "variant = 1\n"),
            at + "variant is a whole number, must be a text in quotes");
}

TEST_F(Variants, AreAnOptionOfTheProgram) {
  const auto run = [&](const std::string& file, const std::string& variant) {
    return run_program(
        RESTFRAME_PROGRAM,
        {"render", file, "--variant", variant, "--size", "8x8", "--quiet", "--output", "shoe.exr"},
        {.folder = folder_.path()});
  };
  EXPECT_EQ(run("shoe.glb", "sea").exit_code, 0);
  const RunResult unknown = run("shoe.glb", "se");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.error,
            "error: shoe.glb: the asset has no variant \"se\", the nearest is \"sea\"\n");
  folder_.write("scene.toml", asset_);
  const RunResult of_scene = run("scene.toml", "sea");
  EXPECT_EQ(of_scene.exit_code, 2);
  EXPECT_EQ(of_scene.error,
            "error: scene.toml: variant \"sea\" goes with an asset; in a scene file, write it as "
            "`variant` in [[object]]\n");
}

TEST(BadVariants, AreNamed) {
  const auto expect = [](const std::string& pointer, const json& value,
                         const std::string& message) {
    GltfBuilder builder = shoe();
    builder.json[json::json_pointer(pointer)] = value;
    test::expect_fault(test::fault_of_bytes(builder.glb()), message);
  };
  const std::string root = "/extensions/KHR_materials_variants";
  expect(root, 1, root + ": is number, must be an object");
  expect(root, json::object(), root + ": variants is missing");
  expect(root + "/variants", "day", root + "/variants: is string, must be an array");
  expect(root + "/variants/0", {{"label", "day"}}, root + "/variants/0: name is missing");
  expect(root + "/variants/1/name", 7, root + "/variants/1/name: is number, must be a string");
  const std::string at = "/meshes/0/primitives/1/extensions/KHR_materials_variants";
  expect(at, json::object(), at + ": mappings is missing");
  expect(at + "/mappings", json::object(), at + "/mappings: is object, must be an array");
  const std::string mapping = at + "/mappings/0";
  expect(mapping + "/material", 4, mapping + "/material: is 4, must be an index below 4");
  expect(mapping, {{"variants", {0}}}, mapping + ": material is missing");
  expect(mapping, {{"material", 0}}, mapping + ": variants is missing");
  expect(mapping + "/variants", 0, mapping + "/variants: is number, must be an array");
  expect(mapping + "/variants/0", 3,
         mapping + "/variants/0: is 3, must be a whole number from 0 to 2");
  expect(mapping + "/variants", {1, 1},
         mapping + "/variants/1: is 1, which the primitive has a material for already");
}

TEST(BadVariants, MustBeDeclared) {
  GltfBuilder builder = shoe();
  builder.json.erase("extensions");
  test::expect_fault(test::fault_of_bytes(builder.glb()),
                     "/meshes/0/primitives/1/extensions/KHR_materials_variants/mappings/0/variants/"
                     "0: there are no variants");
}

}  // namespace
}  // namespace restframe

// How materials use textures: by which coordinates, through which transform, and of which image.

#include <gtest/gtest.h>

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

// A triangle with two sets of texture coordinates, whose base colour is texture 0 of image 0.
GltfBuilder textured_triangle(const json& use) {
  GltfBuilder builder = test::one_triangle();
  const std::string dot = test::png(1, 1, std::string(4, 'x'));
  const int view = builder.add_view(dot.data(), dot.size());
  builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  builder.add("textures", {{"source", 0}});
  builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", use}}}});
  json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  for (const char* set : {"TEXCOORD_0", "TEXCOORD_1"}) {
    primitive["attributes"][set] = builder.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
  }
  return builder;
}

json transformed(const json& transform) {
  return {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
}

class TextureUses : public test::GltfReading {
 protected:
  TextureUse base_color(const GltfBuilder& builder) {
    return load(builder).materials.at(0).base_color_texture;
  }
  std::string place(const std::string& pointer) const {
    return (folder_.path() / "asset.glb").string() + ":" + pointer + ": ";
  }
};

TEST_F(TextureUses, TransformsMayReplaceTheUvSet) {
  EXPECT_EQ(base_color(textured_triangle(transformed({{"texCoord", 1}}))).uv_set, 1);
  json use = transformed({{"texCoord", 0}});
  use["texCoord"] = 1;
  EXPECT_EQ(base_color(textured_triangle(use)).uv_set, 0);
  use = transformed(json::object());
  use["texCoord"] = 1;
  EXPECT_EQ(base_color(textured_triangle(use)).uv_set, 1);
  EXPECT_EQ(warnings_, Warnings{});
}

// In the core and in extensions, each its own.
TEST_F(TextureUses, EachHasItsTransform) {
  const auto use = [](double offset) { return transformed({{"offset", {offset, 0}}}); };
  GltfBuilder builder = textured_triangle(use(1));
  json& m = builder.json["materials"][0];
  m["pbrMetallicRoughness"]["metallicRoughnessTexture"] = use(2);
  m["normalTexture"] = use(3);
  m["emissiveTexture"] = use(4);
  m["extensions"]["KHR_materials_transmission"] = {{"transmissionTexture", use(5)}};
  m["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatNormalTexture", use(6)}};
  builder.json["extensionsRequired"] = {"KHR_texture_transform"};
  const Material material = load(builder).materials.at(0);
  EXPECT_EQ(material.base_color_texture.transform.offset.x, 1);
  EXPECT_EQ(material.metallic_roughness_texture.transform.offset.x, 2);
  EXPECT_EQ(material.normal_texture.transform.offset.x, 3);
  EXPECT_EQ(material.emission_texture.transform.offset.x, 4);
  EXPECT_EQ(material.transmission_texture.transform.offset.x, 5);
  EXPECT_EQ(material.clearcoat_normal_texture.transform.offset.x, 6);
}

TEST_F(TextureUses, WarnWhereCoordinatesAreMissing) {
  GltfBuilder builder = textured_triangle({{"index", 0}, {"texCoord", 1}});
  json& primitives = builder.json["meshes"][0]["primitives"];
  primitives[0]["attributes"].erase("TEXCOORD_1");
  EXPECT_EQ(base_color(builder).uv_set, 0);
  EXPECT_EQ(warnings_, Warnings{place("/materials/0") +
                                "1 of 1 primitives of this material have no TEXCOORD_1; "
                                "TEXCOORD_0 is used"});
  primitives.push_back(primitives[0]);
  primitives[1]["attributes"].erase("TEXCOORD_0");
  builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 0;
  load(builder);
  EXPECT_EQ(warnings_,
            Warnings{place("/materials/0") +
                     "1 of 2 primitives of this material have no TEXCOORD_0; 0 is used"});
}

// Images of kinds that extensions bring: the PNG beside is taken, if there is one.
TEST_F(TextureUses, TakeTheImageThatCanBeRead) {
  for (const std::string extension : {"KHR_texture_basisu", "EXT_texture_webp"}) {
    GltfBuilder builder = textured_triangle({{"index", 0}});
    builder.add("images", {{"uri", "none.ktx2"}});
    builder.json["extensionsUsed"] = {extension};
    builder.json["textures"][0]["extensions"] = {{extension, {{"source", 1}}}};
    const std::string left_out =
        place("/extensionsUsed/0") + "extension \"" + extension + "\" is left out";
    EXPECT_EQ(base_color(builder).texture, 0);
    EXPECT_EQ(warnings_, (Warnings{left_out, place("/images") + "1 images are not used"}));
    builder.json["textures"][0].erase("source");
    EXPECT_EQ(base_color(builder).texture, -1);
    EXPECT_EQ(warnings_, (Warnings{left_out,
                                   place("/materials/0") +
                                       "texture 0 has no PNG or JPEG image and is left out",
                                   place("/images") + "2 images are not used"}));
  }
}

TEST(BadTextureTransforms, AreNamed) {
  const auto fault = [](const json& transform) {
    return test::fault_of_bytes(textured_triangle(transformed(transform)).glb());
  };
  const std::string at =
      "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform";
  test::expect_fault(fault(3), at + ": is number, must be an object");
  test::expect_fault(fault({{"offset", {1}}}), at + "/offset: has 1 numbers, must have 2");
  test::expect_fault(fault({{"offset", {1, "2"}}}), at + "/offset/1: is string, must be a number");
  test::expect_fault(fault({{"scale", 2}}), at + "/scale: is number, must be an array");
  test::expect_fault(fault({{"scale", {1e31, 1}}}), at + "/scale/0: is 1e+31, must be from");
  test::expect_fault(fault({{"rotation", "left"}}), at + "/rotation: is string, must be a number");
  test::expect_fault(fault({{"texCoord", -1}}), at + "/texCoord: is -1, must be a whole number");
}

}  // namespace
}  // namespace restframe

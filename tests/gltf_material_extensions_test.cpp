// KHR_materials_*: what each says is read and kept; what it must not say is refused.

#include <gtest/gtest.h>

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

// A triangle with texture coordinates and textures 0 to 5, whose material has this extension.
GltfBuilder with_extension(const std::string& name, const json& value) {
  GltfBuilder builder = test::one_triangle();
  const std::string dot = test::png(1, 1, std::string(4, '\x80'));
  const int view = builder.add_view(dot.data(), dot.size());
  builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  for (int i = 0; i < 6; ++i) builder.add("textures", {{"source", 0}});
  const json material = {{"extensions", {{name, value}}}};
  json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["material"] = builder.add("materials", material);
  for (const char* set : {"TEXCOORD_0", "TEXCOORD_1"}) {
    primitive["attributes"][set] = builder.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
  }
  builder.json["extensionsRequired"] = {name};
  return builder;
}

class MaterialExtensions : public test::GltfReading {
 protected:
  const Material& material(const std::string& name, const json& value) {
    asset_ = load(with_extension("KHR_materials_" + name, value));
    return asset_.materials.at(0);
  }
  bool is_srgb(const TextureUse& use) const {
    return asset_.textures.at(static_cast<std::size_t>(use.texture)).srgb;
  }

  Asset asset_;
};

json texture(int index) {
  return {{"index", index}};
}

TEST_F(MaterialExtensions, Specular) {
  const Material& m = material("specular", {{"specularFactor", 0.25},
                                            {"specularColorFactor", {2, 1, 0.5}},
                                            {"specularTexture", texture(1)},
                                            {"specularColorTexture", texture(2)}});
  EXPECT_EQ(m.specular.value, 0.25F);
  EXPECT_EQ(m.specular_color.value, Vec3f(2, 1, 0.5F));
  EXPECT_FALSE(is_srgb(m.specular_texture));
  EXPECT_TRUE(is_srgb(m.specular_color_texture));
}

TEST_F(MaterialExtensions, Clearcoat) {
  const Material& m = material(
      "clearcoat", {{"clearcoatFactor", 0.75},
                    {"clearcoatRoughnessFactor", 0.125},
                    {"clearcoatTexture", texture(0)},
                    {"clearcoatRoughnessTexture", texture(1)},
                    {"clearcoatNormalTexture", {{"index", 2}, {"texCoord", 1}, {"scale", 0.5}}}});
  EXPECT_EQ(m.clearcoat.value, 0.75F);
  EXPECT_EQ(m.clearcoat_roughness.value, 0.125F);
  EXPECT_EQ(m.clearcoat_normal_scale, 0.5F);
  EXPECT_EQ(m.clearcoat_normal_texture.uv_set, 1);
  for (const TextureUse& use :
       {m.clearcoat_texture, m.clearcoat_roughness_texture, m.clearcoat_normal_texture}) {
    EXPECT_FALSE(is_srgb(use));
  }
  EXPECT_NE(m.clearcoat_texture.texture, m.clearcoat_roughness_texture.texture);
}

TEST_F(MaterialExtensions, Sheen) {
  const Material& m = material("sheen", {{"sheenColorFactor", {0.5, 0.25, 1}},
                                         {"sheenRoughnessFactor", 0.5},
                                         {"sheenColorTexture", texture(3)},
                                         {"sheenRoughnessTexture", texture(3)}});
  EXPECT_EQ(m.sheen_color.value, Vec3f(0.5F, 0.25F, 1));
  EXPECT_EQ(m.sheen_roughness.value, 0.5F);
  EXPECT_TRUE(is_srgb(m.sheen_color_texture));
  EXPECT_FALSE(is_srgb(m.sheen_roughness_texture));
}

TEST_F(MaterialExtensions, TransmissionsTexture) {
  const Material& m =
      material("transmission", {{"transmissionFactor", 0.5}, {"transmissionTexture", texture(4)}});
  EXPECT_EQ(m.transmission.value, 0.5F);
  EXPECT_FALSE(is_srgb(m.transmission_texture));
}

TEST_F(MaterialExtensions, HaveDefaults) {
  EXPECT_EQ(material("specular", json::object()).specular.value, 1);
  EXPECT_EQ(asset_.materials[0].specular_color.value, Vec3f(1));
  EXPECT_EQ(material("clearcoat", json::object()).clearcoat.value, 0);
  EXPECT_EQ(asset_.materials[0].clearcoat_roughness.value, 0);
  EXPECT_EQ(material("sheen", json::object()).sheen_color.value, Vec3f(0));
  EXPECT_EQ(asset_.materials[0].sheen_roughness.value, 0);
  EXPECT_EQ(asset_.materials[0].normal_scale.value, 1);
}

// A data texture that can not be read is no reason not to show the asset.
TEST_F(MaterialExtensions, GoWithoutTexturesThatCanNotBeRead) {
  GltfBuilder builder =
      with_extension("KHR_materials_sheen",
                     {{"sheenColorTexture", texture(0)}, {"sheenRoughnessTexture", texture(1)}});
  builder.json["images"][0] = {{"uri", "none.png"}};
  const Asset asset = load(builder);
  EXPECT_EQ(asset.materials.at(0).sheen_color_texture.texture, -1);
  EXPECT_EQ(asset.materials.at(0).sheen_roughness_texture.texture, -1);
  EXPECT_TRUE(warned(":/images/0/uri: can not find file \"none.png\""));
}

struct BadValue {
  const char* extension;
  json value;
  const char* message;  // after the extension's place
};

TEST(BadMaterialExtensions, AreNamed) {
  const std::vector<BadValue> bad = {
      {"emissive_strength",
       {{"emissiveStrength", -1}},
       "/emissiveStrength: is -1, must be from 0.0 to 1e+15"},
      {"emissive_strength", {{"emissiveStrength", {1}}}, "/emissiveStrength: is array"},
      {"unlit", true, ": is boolean, must be an object"},
      {"ior", {{"ior", 0.5}}, "/ior: is 0.5, must be at least 1, or 0 for a perfect reflector"},
      {"ior", {{"ior", "1.5"}}, "/ior: is string, must be a number"},
      {"transmission", {{"transmissionFactor", -0.5}}, "/transmissionFactor: is -0.5"},
      {"transmission",
       {{"transmissionTexture", texture(6)}},
       "/transmissionTexture/index: is 6, must be an index below 6"},
      {"volume", {{"thicknessFactor", -1}}, "/thicknessFactor: is -1"},
      {"volume", {{"attenuationDistance", 0}}, "/attenuationDistance: is 0, must be above 0"},
      {"volume", {{"attenuationColor", {0, 0, 2}}}, "/attenuationColor/2: is 2"},
      {"volume", {{"thicknessTexture", 0}}, "/thicknessTexture: is number, must be an object"},
      {"specular", json::array(), ": is array, must be an object"},
      {"specular", {{"specularFactor", 1.5}}, "/specularFactor: is 1.5, must be from 0.0 to 1.0"},
      {"specular",
       {{"specularColorFactor", {1, 1}}},
       "/specularColorFactor: has 2 numbers, must have 3"},
      {"specular", {{"specularColorFactor", {1, -1, 1}}}, "/specularColorFactor/1: is -1"},
      {"specular", {{"specularTexture", {{"texCoord", 0}}}}, "/specularTexture: index is missing"},
      {"specular", {{"specularColorTexture", texture(9)}}, "/specularColorTexture/index: is 9"},
      {"clearcoat", {{"clearcoatFactor", 2}}, "/clearcoatFactor: is 2"},
      {"clearcoat",
       {{"clearcoatRoughnessFactor", "rough"}},
       "/clearcoatRoughnessFactor: is string, must be a number"},
      {"clearcoat", {{"clearcoatTexture", texture(-1)}}, "/clearcoatTexture/index: is -1"},
      {"clearcoat",
       {{"clearcoatRoughnessTexture", {{"index", 0}, {"texCoord", -1}}}},
       "/clearcoatRoughnessTexture/texCoord: is -1"},
      {"clearcoat",
       {{"clearcoatNormalTexture", {{"index", 0}, {"scale", true}}}},
       "/clearcoatNormalTexture/scale: is boolean, must be a number"},
      {"sheen", {{"sheenColorFactor", {1, 1, 1.5}}}, "/sheenColorFactor/2: is 1.5"},
      {"sheen", {{"sheenColorFactor", 1}}, "/sheenColorFactor: is number, must be an array"},
      {"sheen", {{"sheenRoughnessFactor", 1.01}}, "/sheenRoughnessFactor: is 1.01"},
      {"sheen", {{"sheenColorTexture", texture(6)}}, "/sheenColorTexture/index: is 6"},
      {"sheen",
       {{"sheenRoughnessTexture", nullptr}},
       "/sheenRoughnessTexture: is null, must be an object"},
  };
  for (const BadValue& each : bad) {
    const std::string name = std::string("KHR_materials_") + each.extension;
    test::expect_fault(test::fault_of_bytes(with_extension(name, each.value).glb()),
                       "/materials/0/extensions/" + name + each.message);
  }
}

TEST(BadMaterialTextures, AreNamed) {
  const auto fault = [](const std::string& key, const json& use) {
    GltfBuilder builder = with_extension("KHR_materials_unlit", json::object());
    builder.json["materials"][0][key] = use;
    return test::fault_of_bytes(builder.glb());
  };
  test::expect_fault(fault("normalTexture", {{"index", 0}, {"scale", "1"}}),
                     "/materials/0/normalTexture/scale: is string, must be a number");
  test::expect_fault(fault("occlusionTexture", {{"index", 0}, {"strength", 2}}),
                     "/materials/0/occlusionTexture/strength: is 2, must be from 0.0 to 1.0");
  test::expect_fault(fault("emissiveTexture", {{"index", 8}}),
                     "/materials/0/emissiveTexture/index: is 8, must be an index below 6");
}

TEST(BadMaterialTextures, OfOtherKindsAreNamed) {
  const auto fault = [](const char* extension, const json& value) {
    GltfBuilder builder = with_extension("KHR_materials_unlit", json::object());
    builder.json["textures"][2]["extensions"] = {{extension, value}};
    return test::fault_of_bytes(builder.glb());
  };
  test::expect_fault(fault("KHR_texture_basisu", {{"source", 1}}),
                     "/textures/2/extensions/KHR_texture_basisu/source: is 1, must be an index");
  test::expect_fault(fault("EXT_texture_webp", 1),
                     "/textures/2/extensions/EXT_texture_webp: is number, must be an object");
  GltfBuilder required = with_extension("KHR_materials_unlit", json::object());
  required.json["extensionsRequired"].push_back("EXT_texture_webp");
  test::expect_fault(test::fault_of_bytes(required.glb()),
                     "/extensionsRequired/1: extension \"EXT_texture_webp\" is required but not "
                     "supported");
}

}  // namespace
}  // namespace restframe

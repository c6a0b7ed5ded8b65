// Materials, textures and images of glTF files.

#include <gtest/gtest.h>

#include <cmath>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::GltfBuilder;

const std::string red_pixel("\xff\0\0\xff", 4), half_pixel("\x80\x80\x80\x80", 4);

Asset load(const TemporaryFolder& folder, const std::string& bytes, Warnings& warnings) {
  return load_gltf(folder.write("asset.glb", bytes), {}, warnings);
}

Asset load(const GltfBuilder& builder) {
  const TemporaryFolder folder;
  Warnings warnings;
  return load(folder, builder.glb(), warnings);
}

GltfBuilder with_material(const json& material) {
  GltfBuilder builder = test::one_triangle();
  builder.json["meshes"][0]["primitives"][0]["material"] = builder.add("materials", material);
  return builder;
}

TEST(GltfMaterial, HasGltfsDefaults) {
  const Material material = load(with_material(json::object())).materials.at(0);
  EXPECT_EQ(material.name, "material_0");
  EXPECT_EQ(material.base_color.value, Vec3f(1));
  EXPECT_EQ(material.opacity.value, 1);
  EXPECT_EQ(material.metallic.value, 1);
  EXPECT_EQ(material.roughness.value, 1);
  EXPECT_EQ(material.emission.value, Vec3f(0));
  EXPECT_EQ(material.emission_strength.value, 1);
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(material.alpha_cutoff, 0.5F);
  EXPECT_FALSE(material.double_sided);
  EXPECT_FALSE(material.unlit);
  EXPECT_EQ(material.base_color_texture.texture, -1);
}

TEST(GltfMaterial, ReadsEveryFactor) {
  const json source = {{"name", "lamp"},
                       {"pbrMetallicRoughness",
                        {{"baseColorFactor", {0.25, 0.5, 0.75, 0.125}},
                         {"metallicFactor", 0.5},
                         {"roughnessFactor", 0}}},
                       {"emissiveFactor", {1, 0.5, 0}},
                       {"alphaMode", "MASK"},
                       {"alphaCutoff", 0.25},
                       {"doubleSided", true},
                       {"extensions",
                        {{"KHR_materials_emissive_strength", {{"emissiveStrength", 12.5}}},
                         {"KHR_materials_unlit", json::object()}}}};
  const Asset asset = load(with_material(source));
  ASSERT_EQ(asset.materials.size(), 1U);
  const Material& material = asset.materials[0];
  EXPECT_EQ(material.name, "lamp");
  EXPECT_EQ(material.base_color.value, Vec3f(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(material.opacity.value, 0.125F);
  EXPECT_EQ(material.metallic.value, 0.5F);
  EXPECT_EQ(material.roughness.value, 0);
  EXPECT_EQ(material.emission.value, Vec3f(1, 0.5F, 0));
  EXPECT_EQ(material.emission_strength.value, 12.5F);
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, 0.25F);
  EXPECT_TRUE(material.double_sided);
  EXPECT_TRUE(material.unlit);
}

TEST(GltfMaterial, ReadsGlass) {
  const json source = {{"extensions",
                        {{"KHR_materials_ior", {{"ior", 1.75}}},
                         {"KHR_materials_transmission", {{"transmissionFactor", 0.5}}},
                         {"KHR_materials_volume",
                          {{"attenuationDistance", 2.5}, {"attenuationColor", {0.5, 1, 0.25}}}}}}};
  GltfBuilder builder = with_material(source);
  builder.json["extensionsRequired"] = {"KHR_materials_ior", "KHR_materials_transmission",
                                        "KHR_materials_volume"};
  const Material material = load(builder).materials.at(0);
  EXPECT_EQ(material.ior.value, 1.75F);
  EXPECT_EQ(material.transmission.value, 0.5F);
  EXPECT_EQ(material.attenuation_distance.value, 2.5F);
  EXPECT_EQ(material.attenuation_color.value, Vec3f(0.5F, 1, 0.25F));
}

// As the extensions say: a volume of some thickness makes a body of it.
TEST(GltfMaterial, IsASheetWithoutThickness) {
  const auto read = [](json extensions) {
    const json source = {{"extensions", std::move(extensions)}};
    return load(with_material(source)).materials.at(0);
  };
  const json glass = {{"transmissionFactor", 1}};
  EXPECT_FALSE(read(json::object()).thin_walled);
  EXPECT_TRUE(read({{"KHR_materials_transmission", glass}}).thin_walled);
  EXPECT_TRUE(read({{"KHR_materials_transmission", glass},
                    {"KHR_materials_volume", {{"attenuationDistance", 1}}}})
                  .thin_walled);
  EXPECT_FALSE(read({{"KHR_materials_transmission", glass},
                     {"KHR_materials_volume", {{"thicknessFactor", 0.5}}}})
                   .thin_walled);
}

TEST(GltfMaterial, EmptyGlassHasDefaults) {
  const Material material = load(with_material({{"extensions",
                                                 {{"KHR_materials_ior", json::object()},
                                                  {"KHR_materials_transmission", json::object()},
                                                  {"KHR_materials_volume", json::object()}}}}))
                                .materials.at(0);
  EXPECT_EQ(material.ior.value, 1.5F);
  EXPECT_EQ(material.transmission.value, 0);
  EXPECT_EQ(material.attenuation_distance.value, 0);
  EXPECT_EQ(material.attenuation_color.value, Vec3f(1));
}

GltfBuilder with_textures() {
  GltfBuilder builder = with_material({{"pbrMetallicRoughness",
                                        {{"baseColorTexture", {{"index", 1}, {"texCoord", 1}}},
                                         {"metallicRoughnessTexture", {{"index", 0}}}}},
                                       {"emissiveTexture", {{"index", 0}}}});
  json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  for (const char* set : {"TEXCOORD_0", "TEXCOORD_1"}) {
    attributes[set] = builder.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
  }
  builder.json["samplers"] = {
      {{"magFilter", 9728}, {"minFilter", 9985}, {"wrapS", 33071}, {"wrapT", 33648}}};
  builder.json["textures"] = {{{"source", 1}}, {{"source", 0}, {"sampler", 0}}};
  const std::string first = test::png(1, 1, red_pixel), second = test::png(1, 1, half_pixel);
  const int view = builder.add_view(first.data(), first.size());
  builder.add("images", {{"bufferView", view}, {"mimeType", "image/png"}, {"name", "red"}});
  builder.add("images", {{"uri", "data:image/png;base64," + test::base64(second)}});
  return builder;
}

TEST(GltfMaterial, ReadsTexturesWithTheirSamplers) {
  const Asset asset = load(with_textures());
  const Material& material = asset.materials.at(0);
  ASSERT_EQ(asset.textures.size(), 3U);  // texture 0 both as data and as colour
  ASSERT_EQ(asset.images.size(), 2U);
  const TextureUse color = material.base_color_texture;
  EXPECT_EQ(color.uv_set, 1);
  const Texture& texture = asset.textures.at(static_cast<std::size_t>(color.texture));
  EXPECT_TRUE(texture.srgb);
  EXPECT_EQ(texture.filter, TextureFilter::nearest);
  EXPECT_EQ(texture.shrunken_filter, TextureFilter::linear);
  EXPECT_EQ(texture.mip_filter, MipFilter::nearest);
  EXPECT_EQ(texture.wrap_u, Wrap::clamp);
  EXPECT_EQ(texture.wrap_v, Wrap::mirrored_repeat);
  const Image& image = asset.images.at(static_cast<std::size_t>(texture.image));
  EXPECT_EQ(image.name, "red");
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{255, 0, 0, 255}));

  const auto texture_of = [&](const TextureUse& use) {
    return asset.textures.at(static_cast<std::size_t>(use.texture));
  };
  EXPECT_FALSE(texture_of(material.metallic_roughness_texture).srgb);
  EXPECT_TRUE(texture_of(material.emission_texture).srgb);
  EXPECT_EQ(texture_of(material.emission_texture).filter, TextureFilter::linear);
  EXPECT_EQ(texture_of(material.emission_texture).image,
            texture_of(material.metallic_roughness_texture).image);
}

TEST(GltfMaterial, ReadsImageFilesBesideTheAsset) {
  GltfBuilder builder = with_textures();
  builder.json["images"][1] = {{"uri", "images/half.png"}};
  const TemporaryFolder folder;
  folder.write("images/half.png", test::png(1, 1, half_pixel));
  Warnings warnings;
  EXPECT_EQ(load(folder, builder.glb(), warnings).images.at(1).rgba.at(0), 128);
}

TEST(GltfMaterial, ReplacesABadImageThatIsOnlyData) {
  GltfBuilder builder = with_textures();
  builder.json["images"][1] = {{"uri", "missing.png"}};
  builder.json["materials"][0].erase("emissiveTexture");
  const TemporaryFolder folder;
  Warnings warnings;
  const Asset asset = load(folder, builder.glb(), warnings);
  EXPECT_EQ(asset.images.size(), 2U);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("/images/1/uri: can not find file \"missing.png\""),
            std::string::npos);
  EXPECT_EQ(asset.materials.at(0).metallic_roughness_texture.texture, -1);
  EXPECT_GE(asset.materials.at(0).base_color_texture.texture, 0);
}

TEST(GltfMaterial, NamesMapsThatPicturesDoNotShow) {
  GltfBuilder builder = with_textures();
  json& material = builder.json["materials"][0];
  material["normalTexture"] = {{"index", 0}, {"scale", -0.5}};
  material["occlusionTexture"] = {{"index", 0}, {"strength", 0.5}};
  material["extensions"] = {
      {"KHR_materials_transmission", {{"transmissionTexture", {{"index", 0}}}}},
      {"KHR_materials_sheen", {{"sheenColorTexture", {{"index", 0}}}}},
      {"KHR_materials_volume", {{"thicknessTexture", {{"index", 0}}}}}};
  const TemporaryFolder folder;
  Warnings warnings;
  const Material read = load(folder, builder.glb(), warnings).materials.at(0);
  EXPECT_EQ(read.normal_scale.value, -0.5F);
  EXPECT_GE(read.normal_texture.texture, 0);
  EXPECT_GE(read.transmission_texture.texture, 0);
  const std::string file = (folder.path() / "asset.glb").string();
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0], file + ":/materials: occlusionTexture of 1 materials is left out");
  EXPECT_EQ(warnings[1], file + ":/materials: thicknessTexture of 1 materials is left out");
}

TEST(GltfMaterial, AnIndexOfRefractionOfZeroReflectsAll) {
  const json source = {{"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}};
  const float ior = load(with_material(source)).materials.at(0).ior.value;
  EXPECT_NEAR(std::pow((ior - 1) / (ior + 1), 2), 1, 1e-5);
}

}  // namespace
}  // namespace restframe

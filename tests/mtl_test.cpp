// MTL statements and what becomes of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <locale>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A PNG of 2 x 1 pixels: red and green.
const std::string red_green =
    "\x89PNG\r\n\x1a\n" +
    std::string("\0\0\0\rIHDR\0\0\0\2\0\0\0\1\10\2\0\0\0\x7b\x40\xe8\xdd", 25) +
    std::string("\0\0\0\xfIDATx\x9c\x63\xf8\xcf\xc0\xc0\xf0\x9f\1\0\7\xff\1\xff", 23) +
    std::string("\1\x7f\x89\xa7\0\0\0\0IEND\xae\x42\x60\x82", 16);

class Mtl : public testing::Test {
 protected:
  // The material `a` of an MTL file that goes on as `text`.
  Material load(const std::string& text) {
    files_.write("m.mtl", "newmtl a\n" + text);
    warnings_.clear();
    asset_ = load_obj(
        files_.write("asset.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"),
        ImportLimits{}, warnings_);
    return asset_.materials.at(0);
  }
  std::string fault_of(const std::string& text) {
    try {
      load(text);
      return "";
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(what.find("m.mtl"));
    }
  }

  TemporaryFolder files_;
  Warnings warnings_;
  Asset asset_;
};

TEST_F(Mtl, ShininessIsTheWidthOfALobe) {
  // alpha^2 = 2/(Ns + 2), roughness^2 = alpha.
  for (const double ns : {0.0, 2.0, 30.0, 1000.0}) {
    const double roughness = load("Ns " + std::to_string(ns) + "\n").roughness.value;
    EXPECT_NEAR(std::pow(roughness, 4) * (ns + 2), 2, 1e-5) << ns;
  }
  EXPECT_FLOAT_EQ(load("Ns 1000\nPr 0.25\n").roughness.value, 0.25F);
  EXPECT_FLOAT_EQ(load("Kd 1 1 1\n").roughness.value, 1);
}

TEST_F(Mtl, PhysicalParameters) {
  const Material m = load("Pr 0.2\nPm 0.3\nPs 0.4\nPc 0.5\nPcr 0.6\nKe 0.1\naniso 0.7\n");
  EXPECT_FLOAT_EQ(m.roughness.value, 0.2F);
  EXPECT_FLOAT_EQ(m.metallic.value, 0.3F);
  EXPECT_EQ(m.sheen_color.value, Vec3f(0.4F));
  EXPECT_FLOAT_EQ(m.clearcoat.value, 0.5F);
  EXPECT_FLOAT_EQ(m.clearcoat_roughness.value, 0.6F);
  EXPECT_EQ(m.emission.value, Vec3f(0.1F));
  EXPECT_THAT(warnings_, ElementsAre(testing::EndsWith("m.mtl: not used: aniso")));
}

TEST_F(Mtl, ReflectionGoesByTheIlluminationModel) {
  EXPECT_EQ(load("Kd 1 1 1\n").specular_color.value, Vec3f(1));
  EXPECT_EQ(load("Ks 0.5 0.5 0.5\nillum 2\n").specular_color.value, Vec3f(1));
  EXPECT_EQ(load("Ks 0.25 0 0\n").specular_color.value, Vec3f(0.5F, 0, 0));
  EXPECT_EQ(load("Ks 1 1 1\nillum 1\n").specular.value, 0);
  EXPECT_TRUE(load("illum 0\n").unlit);
  EXPECT_FALSE(load("illum 2\n").unlit);
  // ((1.5 - 1)/(1.5 + 1))^2 = 0.04 of the light is reflected, times 12.5 gives Ks.
  EXPECT_LT(glm::distance(load("Ks 0.5 0.5 0.5\nillum 3\n").specular_color.value, Vec3f(12.5F)),
            1e-4F);
  load("illum 11\n");
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("illum is 11, must be 0 to 9; 2 is used")));
}

TEST_F(Mtl, GlassLetsLightThrough) {
  const Material clear = load("illum 7\nNi 1.33\nTf 0.5 1 1\nKd 0 0 0\n");
  EXPECT_EQ(clear.transmission.value, 1);
  EXPECT_EQ(clear.base_color.value, Vec3f(0.5F, 1, 1));
  EXPECT_FLOAT_EQ(clear.ior.value, 1.33F);
  EXPECT_EQ(clear.alpha_mode, AlphaMode::opaque);
  const Material half = load("illum 6\nd 0.25\nKd 0.1 0.2 0.3\n");
  EXPECT_FLOAT_EQ(half.transmission.value, 0.75F);
  EXPECT_EQ(half.opacity.value, 1);
  EXPECT_EQ(half.base_color.value, Vec3f(0.1F, 0.2F, 0.3F));
  load("d 0.5\nTf 1 0 0\n");
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("Tf is used with illum 6 and 7 only")));
}

TEST_F(Mtl, OpacityHasTwoNames) {
  EXPECT_FLOAT_EQ(load("d 0.75\nTr 0.5\n").opacity.value, 0.75F);
  EXPECT_FLOAT_EQ(load("Tr 0.25\n").opacity.value, 0.75F);
  EXPECT_EQ(asset_.materials[0].alpha_mode, AlphaMode::blend);
  load("Tr 1\n");
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"a\": is wholly transparent")));
}

TEST_F(Mtl, NumbersAsProgramsWriteThem) {
  const Material m = load("  Kd\t+1. .5 1e-3 # grey\nKe 2\nNi 0\nKA 1 1 1\nkS 0 0 0\n");
  EXPECT_EQ(m.base_color.value, Vec3f(1, 0.5F, 0.001F));
  EXPECT_EQ(m.emission.value, Vec3f(2));
  EXPECT_EQ(m.ior.value, 1.5F);
  EXPECT_EQ(m.specular_color.value, Vec3f(0));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Mtl, NumbersDoNotGoByTheLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  const Material m = load("Kd 0.5 0.25 1e-400\n");
  std::locale::global(before);
  EXPECT_EQ(m.base_color.value, Vec3f(0.5F, 0.25F, 0));
}

TEST_F(Mtl, MapsArePlacedByTheirOptions) {
  files_.write("a map.png", red_green);
  const Material m = load("map_Kd -s 2 4 1 -o 0.25 0.5 a map.png\n");
  const UvTransform& transform = m.base_color_texture.transform;
  // At the format's (u, v) the picture is at (2 u + 0.25, 4 v + 0.5), v upwards in both.
  for (const Vec2f& uv : {Vec2f(0, 0), Vec2f(1, 0), Vec2f(0.5F, 0.75F)}) {
    const Vec2f expected(2 * uv.x + 0.25F, 1 - (4 * uv.y + 0.5F));
    EXPECT_LT(glm::distance(transform({uv.x, 1 - uv.y}), expected), 1e-6F);
  }
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Mtl, OptionsThatChangeThePicture) {
  files_.write("p.png", red_green);
  load("map_Kd p.png -mm 0.2 0.4 -clamp on -blendu off -blendv off\n");
  ASSERT_EQ(asset_.images.size(), 1U);
  EXPECT_EQ(asset_.images[0].rgba, (std::vector<std::uint8_t>{153, 51, 51, 255, 51, 153, 51, 255}));
  EXPECT_EQ(asset_.textures[0].wrap_u, Wrap::clamp);
  EXPECT_EQ(asset_.textures[0].filter, TextureFilter::nearest);
  load("map_Kd -imfchan g p.png\n");
  EXPECT_EQ(asset_.images[0].rgba, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255}));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(Mtl, OptionsThatAreNotUsedAreNamedOnce) {
  files_.write("p.png", red_green);
  load("map_Kd -texres 512 -t 1 2 3 p.png\nmap_Ke -texres 512 -boost 2 -cc on p.png\n");
  EXPECT_THAT(warnings_, ElementsAre(testing::EndsWith(
                             "texture options that are not used: -boost, -cc, -t, -texres")));
  EXPECT_EQ(asset_.textures.size(), 1U);
}

TEST_F(Mtl, FaultsOfOptions) {
  EXPECT_EQ(fault_of("map_Kd -s x.png\n"), "m.mtl:2:8: -s must be followed by a number");
  EXPECT_EQ(fault_of("map_Kd -mm 0 nan x.png\n"), "m.mtl:2:14: \"nan\" is not a finite number");
  EXPECT_EQ(fault_of("map_Kd -clamp yes x.png\n"),
            "m.mtl:2:8: -clamp must be followed by on or off");
  EXPECT_EQ(fault_of("map_Kd -imfchan x x.png\n"),
            "m.mtl:2:8: -imfchan must be followed by one of r, g, b, m, l and z");
  EXPECT_EQ(fault_of("map_Kd -bm\n"), "m.mtl:2:8: -bm must be followed by a number");
}

TEST_F(Mtl, RoughnessAndMetalShareATexture) {
  files_.write("p.png", red_green);
  const Material m = load("map_Pr -imfchan r p.png\nmap_Pm -imfchan g p.png\nPm 0.5\n");
  EXPECT_EQ(m.roughness.value, 1);
  EXPECT_EQ(m.metallic.value, 0.5F);
  ASSERT_EQ(asset_.images.size(), 1U);
  EXPECT_EQ(asset_.images[0].rgba, (std::vector<std::uint8_t>{255, 255, 0, 255, 255, 0, 255, 255}));
  EXPECT_FALSE(asset_.textures[0].srgb);
}

TEST_F(Mtl, OpacityMapsBecomeAlpha) {
  files_.write("p.png", red_green);
  const Material m = load("map_Kd p.png\nmap_d -imfchan g p.png\n");
  EXPECT_EQ(m.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(asset_.images[0].rgba, (std::vector<std::uint8_t>{255, 0, 0, 0, 0, 255, 0, 255}));
  // A picture that is opaque all over, used for both as programs do, hides nothing.
  load("map_Kd p.png\nmap_d p.png\n");
  EXPECT_EQ(asset_.images[0].rgba[3], 255);
}

TEST_F(Mtl, NormalAndBumpMaps) {
  files_.write("p.png", red_green);
  const Material normal = load("norm -bm 0.5 p.png\n");
  EXPECT_EQ(normal.normal_texture.texture, 0);
  EXPECT_EQ(normal.normal_scale.value, 0.5F);
  EXPECT_FALSE(asset_.textures[0].srgb);
  EXPECT_EQ(load("map_Bump p.png\n").normal_texture.texture, -1);
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("map_Bump: a height map, not used")));
}

TEST_F(Mtl, BlackUnderATextureIsNotMeant) {
  files_.write("p.png", red_green);
  EXPECT_EQ(load("Kd 0 0 0\nmap_Kd p.png\n").base_color.value, Vec3f(1));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("Kd is black")));
  // A picture that is not there leaves the factor.
  EXPECT_EQ(load("Kd 0.5 0 0\nmap_Kd gone.png\n").base_color.value, Vec3f(0.5F, 0, 0));
  EXPECT_EQ(load("map_Kd gone.png\n").base_color.value, Vec3f(0.8F));
}

TEST_F(Mtl, OtherFormatsAreNamed) {
  files_.write("p.tga", "\0\0\2 no PNG");
  load("map_Kd p.tga\nmap_Ke\n");
  EXPECT_THAT(warnings_, Contains(HasSubstr("image \"p.tga\" is neither PNG nor JPEG, not used")));
  EXPECT_THAT(warnings_, Contains(HasSubstr("map_Ke: names no file, not used")));
}

}  // namespace
}  // namespace restframe

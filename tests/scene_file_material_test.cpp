// Every property of a material is a key of [[material]], as a constant and over a clock.

#include <gtest/gtest.h>

#include "scene/material_properties.h"
#include "support/scene_reading.h"

namespace restframe {
namespace {

class MaterialKeys : public SceneReading {
 protected:
  static std::string key_in_file(const std::string& line) {
    return "[[object]]\nasset = \"paint.obj\"\n[[material]]\nname = \"paint\"\n" + line;
  }
  Material material(const std::string& line) { return read(key_in_file(line)).materials.at(0); }
};

// Within every property's range.
constexpr const char* some_number = "1";
constexpr const char* some_color = "[0.25, 0.5, 1]";

TEST_F(MaterialKeys, AreAllRead) {
  for (const NumberProperty& p : number_properties) {
    EXPECT_EQ((material(std::string(p.name) + " = " + some_number).*p.member).value, 1) << p.name;
  }
  for (const ColorProperty& p : color_properties) {
    EXPECT_EQ((material(std::string(p.name) + " = " + some_color).*p.member).value,
              Vec3f(0.25F, 0.5F, 1))
        << p.name;
  }
}

TEST_F(MaterialKeys, MayAllBeFunctions) {
  for (const NumberProperty& p : number_properties) {
    const std::string function = " = {keys = [[0, 1], [1, 1]]}";
    EXPECT_EQ((material(p.name + function).*p.member).function, 0) << p.name;
  }
  for (const ColorProperty& p : color_properties) {
    const std::string function = " = {period = 1, intervals = [[0, 0.5, \"red\"]]}";
    EXPECT_EQ((material(p.name + function).*p.member).function, 0) << p.name;
  }
}

TEST_F(MaterialKeys, TakeWhatTheirRangeHolds) {
  for (const NumberProperty& p : number_properties) {
    SCOPED_TRACE(p.name);
    const std::string key = std::string(p.name) + " = ";
    const auto value = [&](const char* text) { return (material(key + text).*p.member).value; };
    const auto count = [&](const char* text) { return faults(key_in_file(key + text)).size(); };
    EXPECT_EQ(count("1.001"), p.high == 1 ? 1U : 0U);
    EXPECT_EQ(count("-0.001"), p.low >= 0 ? 1U : 0U);
    if (p.high > 1) {
      EXPECT_EQ(value("1e9"), 1e9F);
    }
    if (p.low < 0) {
      EXPECT_EQ(value("-1e9"), -1e9F);
    }
  }
}

}  // namespace
}  // namespace restframe

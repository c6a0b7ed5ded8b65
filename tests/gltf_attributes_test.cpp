// Vertex attributes of every type that glTF and KHR_mesh_quantization allow, and of those they do not.

#include <cmath>
#include <limits>

#include "support/gltf_faults.h"
#include "support/gltf_reading.h"

namespace restframe {
namespace {

using nlohmann::json;
using test::expect_fault;
using test::fault_of_bytes;
using test::GltfBuilder;
using test::triangle;
using GltfAttributes = test::GltfReading;

const std::string at = "/meshes/0/primitives/0/attributes";

// A triangle with one more attribute, whose accessor `make` adds.
template <class Make>
GltfBuilder triangle_with(const char* name, const Make& make, bool quantized = false) {
  GltfBuilder builder;
  json attributes = {{"POSITION", builder.add_accessor<float>(triangle, "VEC3")}};
  attributes[name] = make(builder);
  if (std::string(name) == "TANGENT") {
    attributes["NORMAL"] = builder.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  }
  builder.add_mesh({{"attributes", attributes}});
  if (quantized) builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  return builder;
}

// The attribute as vectors of that type: 0, the greatest and the least number it can hold.
template <class T>
auto extremes(const char* type, int components, bool normalized) {
  return [=](GltfBuilder& builder) {
    std::vector<T> values;
    for (const T value : {T{0}, std::numeric_limits<T>::max(), std::numeric_limits<T>::lowest()}) {
      for (int c = 0; c < components; ++c) values.push_back(value);
    }
    // Rows of vertex attributes are multiples of 4 bytes.
    const std::size_t size = sizeof(T) * static_cast<std::size_t>(components);
    const std::size_t stride = (size + 3) / 4 * 4;
    std::vector<std::uint8_t> rows(3 * stride);
    for (std::size_t i = 0; i < 3; ++i) {
      std::memcpy(&rows[i * stride], &values[i * static_cast<std::size_t>(components)], size);
    }
    const int view = builder.add_view(rows, static_cast<int>(stride));
    constexpr int component = 5120 + 2 * (sizeof(T) == 2) + !std::is_signed_v<T>;
    return builder.add_accessor_of_view(view, component, type, values.size(), normalized);
  };
}

// With quantization, and whatever it says without.
template <class T>
std::string fault_of(const char* name, const char* type, int components, bool normalized,
                     bool quantized) {
  return fault_of_bytes(
      triangle_with(name, extremes<T>(type, components, normalized), quantized).glb());
}

// Of each integer type, not normalized and normalized: i8 u8 i16 u16.
std::string allowed(const char* name, const char* type, int components, bool quantized) {
  std::string result;
  for (const bool normalized : {false, true}) {
    const auto add = [&](const std::string& fault) { result += fault.empty() ? 'y' : '-'; };
    add(fault_of<std::int8_t>(name, type, components, normalized, quantized));
    add(fault_of<std::uint8_t>(name, type, components, normalized, quantized));
    add(fault_of<std::int16_t>(name, type, components, normalized, quantized));
    add(fault_of<std::uint16_t>(name, type, components, normalized, quantized));
  }
  return result;
}

// The tables of glTF 2.0, 3.7.2.1, and of the extension.
TEST_F(GltfAttributes, ComponentTypesAreThoseOfTheSpecifications) {
  EXPECT_EQ(allowed("NORMAL", "VEC3", 3, false), "--------");
  EXPECT_EQ(allowed("NORMAL", "VEC3", 3, true), "----y-y-");
  EXPECT_EQ(allowed("TANGENT", "VEC4", 4, false), "--------");
  EXPECT_EQ(allowed("TANGENT", "VEC4", 4, true), "----y-y-");
  EXPECT_EQ(allowed("TEXCOORD_0", "VEC2", 2, false), "-----y-y");
  EXPECT_EQ(allowed("TEXCOORD_0", "VEC2", 2, true), "yyyyyyyy");
  EXPECT_EQ(allowed("COLOR_0", "VEC3", 3, false), "-----y-y");
  EXPECT_EQ(allowed("COLOR_0", "VEC4", 4, true), "-----y-y");
  EXPECT_EQ(allowed("POSITION", "VEC3", 3, false), "--------");
  EXPECT_EQ(allowed("POSITION", "VEC3", 3, true), "yyyyyyyy");
  EXPECT_EQ(fault_of<std::int8_t>("NORMAL", "VEC3", 3, true, false),
            "a.glb:" + at +
                "/NORMAL: has componentType 5120, normalized, which it can have with "
                "KHR_mesh_quantization only");
  EXPECT_EQ(
      fault_of<std::int8_t>("NORMAL", "VEC3", 3, false, true),
      "a.glb:" + at + "/NORMAL: has componentType 5120, not normalized, which it can not have");
}

template <class T>
void expect_extremes(const Mesh& mesh, bool normalized) {
  const float most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::lowest();
  const auto whole = [&](float x) { return normalized ? std::max(x / most, -1.0F) : x; };
  EXPECT_EQ(mesh.positions.at(0), Vec3f(0));
  EXPECT_EQ(mesh.positions.at(1), Vec3f(whole(most)));
  EXPECT_EQ(mesh.positions.at(2), Vec3f(whole(least)));
}

TEST_F(GltfAttributes, QuantizedNumbersAreWholeOrFractions) {
  for (const bool normalized : {false, true}) {
    const auto read = [&](const auto& make) {
      return load(triangle_with("POSITION", make, true)).meshes.at(0);
    };
    expect_extremes<std::int8_t>(read(extremes<std::int8_t>("VEC3", 3, normalized)), normalized);
    expect_extremes<std::uint8_t>(read(extremes<std::uint8_t>("VEC3", 3, normalized)), normalized);
    expect_extremes<std::int16_t>(read(extremes<std::int16_t>("VEC3", 3, normalized)), normalized);
    expect_extremes<std::uint16_t>(read(extremes<std::uint16_t>("VEC3", 3, normalized)),
                                   normalized);
  }
}

TEST_F(GltfAttributes, ColorsOfEveryKindAreTheSame) {
  const std::vector<Vec4f> rgba = {{1, 0, 0.2F, 0.4F}, {0, 0, 0, 0}, {0, 0, 0, 1}};
  for (const bool alpha : {false, true}) {
    const char* type = alpha ? "VEC4" : "VEC3";
    const auto numbers = [&](float scale) {
      std::vector<float> result;
      for (const Vec4f& color : rgba) {
        for (int c = 0; c < (alpha ? 4 : 3); ++c) result.push_back(std::round(color[c] * scale));
      }
      return result;
    };
    const auto bytes = numbers(255), words = numbers(65535);
    std::vector<float> floats = numbers(5);
    for (float& f : floats) f /= 5;
    const auto check = [&](const auto& make) {
      const std::vector<Vec4f> colors = load(triangle_with("COLOR_0", make)).meshes.at(0).colors;
      ASSERT_EQ(colors.size(), 3U);
      for (std::size_t i = 0; i < 3; ++i) {
        Vec4f expected = rgba[i];
        if (!alpha) expected.w = 1;
        EXPECT_LT(glm::distance(colors[i], expected), 1e-6F);
      }
    };
    check([&](GltfBuilder& b) { return b.add_accessor<float>(floats, type); });
    check([&](GltfBuilder& b) {
      return b.add_accessor<std::uint16_t>({words.begin(), words.end()}, type, true);
    });
    check([&](GltfBuilder& b) {
      return b.add_accessor<std::uint8_t>({bytes.begin(), bytes.end()}, type, true);
    });
  }
}

TEST_F(GltfAttributes, ColorsAreClamped) {
  const auto make = [](GltfBuilder& b) {
    return b.add_accessor<float>({2, -1, 0.5F, 0, 0, 0, 1, 1, 1}, "VEC3");
  };
  EXPECT_EQ(load(triangle_with("COLOR_0", make)).meshes.at(0).colors.at(0), Vec4f(1, 0, 0.5F, 1));
}

TEST_F(GltfAttributes, AsManyUvSetsAsThereAre) {
  GltfBuilder builder;
  json attributes = {{"POSITION", builder.add_accessor<float>(triangle, "VEC3")}};
  for (int set = 0; set < 5; ++set) {
    const auto x = static_cast<float>(set);
    attributes["TEXCOORD_" + std::to_string(set)] =
        builder.add_accessor<float>({x, 0, 0, x, x, x}, "VEC2");
  }
  builder.add_mesh({{"attributes", attributes}});
  // A second primitive has one set only: the others are 0 there.
  json second = {{"POSITION", 0}, {"TEXCOORD_0", 1}};
  builder.json["meshes"][0]["primitives"].push_back({{"attributes", second}});
  const Mesh mesh = load(builder).meshes.at(0);
  ASSERT_EQ(mesh.uvs.size(), 5U);
  for (std::size_t set = 0; set < 5; ++set) {
    ASSERT_EQ(mesh.uvs[set].size(), 6U);
    EXPECT_EQ(mesh.uvs[set][2], Vec2f(static_cast<float>(set)));
    EXPECT_EQ(mesh.uvs[set][5], Vec2f(0));
  }
  builder.json["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_2");
  expect_fault(fault_of_bytes(builder.glb()),
               at + ": has 4 attributes TEXCOORD_n, but no TEXCOORD_2");
}

TEST_F(GltfAttributes, TangentsAreKeptWithNormals) {
  const auto make = [](GltfBuilder& b) {
    return b.add_accessor<float>({2, 0, 0, 1, 0, 3, 4, -1, 0, 0, 0, 1}, "VEC4");
  };
  GltfBuilder builder = triangle_with("TANGENT", make);
  EXPECT_EQ(load(builder).meshes.at(0).tangents,
            (std::vector<Vec4f>{{1, 0, 0, 1}, {0, 0.6F, 0.8F, -1}, {0, 0, 0, 0}}));
  EXPECT_TRUE(warned(at + "/TANGENT: 1 tangents have no direction and are left out"));
  builder.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  EXPECT_TRUE(load(builder).meshes.at(0).tangents.empty());
}

}  // namespace
}  // namespace restframe

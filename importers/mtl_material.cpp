#include "importers/mtl_material.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "scene/message.h"

namespace restframe {
namespace {

constexpr float default_grey = 0.8F;

class Converter {
 public:
  Converter(const MtlMaterial& source, Warnings& warnings)
      : source_(source), warnings_(warnings), illum_(illumination()) {}

  Material convert() {
    Material result = grey_material(source_.name);
    if (const auto kd = color("kd", "Kd", 1)) result.base_color.value = *kd;
    if (const auto ke = color("ke", "Ke", greatest)) result.emission.value = *ke;
    if (!is_zero("ni")) result.ior.value = number("ni", "Ni", 1, greatest).value_or(1.5F);
    if (const auto pm = number("pm", "Pm", 0, 1)) result.metallic.value = *pm;
    result.roughness.value = roughness();
    result.opacity.value = opacity();
    result.unlit = illum_ == 0;
    add_reflection(result);
    add_layers(result);
    if (illum_ == 6 || illum_ == 7) {
      make_glass(result);
    } else if (result.opacity.value < 1 && color("tf", "Tf", 1).value_or(Vec3f(1)) != Vec3f(1)) {
      warn("Tf is used with illum 6 and 7 only");
    }
    if (result.opacity.value < 1) result.alpha_mode = AlphaMode::blend;
    if (result.opacity.value <= 0) warn("is wholly transparent: nothing of it shows");
    return result;
  }

 private:
  static constexpr float greatest = 1e15F;

  // 0: constant colour; 1: matt; 2: with highlights; 3 and more: with reflections; of these 4, 6, 7
  // and 9 are see-through, 6 and 7 with refraction. 2 where it is not given.
  int illumination() {
    const auto given = source_.numbers.find("illum");
    if (given == source_.numbers.end()) return 2;
    const float value = given->second;
    if (value >= 0 && value < 10 && value == std::floor(value)) return static_cast<int>(value);
    warn(fmt::format("illum is {}, must be 0 to 9; 2 is used", value));
    return 2;
  }

  // The specification's highlights are powers of the cosine between normal and half vector; such a
  // power n is as wide as a microfacet lobe of alpha^2 = 2/(n + 2) (Walter et al. 2007, equation
  // 34), and glTF's roughness is the root of alpha.
  float roughness() {
    if (const auto pr = number("pr", "Pr", 0, 1)) return *pr;
    const auto ns = number("ns", "Ns", 0, 1e9F);
    return ns ? std::pow(2 / (*ns + 2), 0.25F) : 1.0F;
  }

  // Tr is 1 - d; where both are given, d holds.
  float opacity() {
    const auto d = number("d", "d", 0, 1);
    const auto tr = number("tr", "Tr", 0, 1);
    if (d) return *d;
    return tr ? 1 - *tr : 1.0F;
  }

  // Ks of a half is what glTF's dielectrics reflect, as common programs write and read it; where
  // illum asks for traced reflections, Ks is the reflectance itself, seen straight on.
  void add_reflection(Material& material) {
    if (illum_ <= 1) {
      material.specular.value = 0;
      return;
    }
    std::optional<Vec3f> ks = color("ks", "Ks", 1);
    if (!ks && source_.maps.count("ks")) ks = Vec3f(1);
    if (!ks) return;
    const float n = material.ior.value, root = (n - 1) / (n + 1);
    const bool is_traced = illum_ >= 3 && root > 0;
    material.specular_color.value = *ks * (is_traced ? 1 / (root * root) : 2.0F);
  }

  void add_layers(Material& material) {
    material.clearcoat.value = number("pc", "Pc", 0, 1).value_or(0.0F);
    material.clearcoat_roughness.value = number("pcr", "Pcr", 0, 1).value_or(0.0F);
    const auto ps = number("ps", "Ps", 0, 1);
    if (!ps && !source_.maps.count("ps")) return;
    material.sheen_color.value = Vec3f(ps.value_or(1.0F));
    material.sheen_roughness.value = 0.5F;  // the format has none
  }

  // What is not opaque lets light through its body, coloured by Tf.
  void make_glass(Material& material) {
    const bool is_given = material.opacity.value < 1;
    material.transmission.value = is_given ? 1 - material.opacity.value : 1.0F;
    material.opacity.value = 1;
    const auto tf = color("tf", "Tf", 1);
    if (!is_given) material.base_color.value = tf.value_or(Vec3f(1));
  }

  // Programs write an index of refraction of 0 where they have none.
  bool is_zero(const char* key) const {
    const auto given = source_.numbers.find(key);
    return given != source_.numbers.end() && given->second == 0;
  }

  std::optional<float> number(const char* key, const char* written, float least, float most) {
    const auto given = source_.numbers.find(key);
    if (given == source_.numbers.end()) return std::nullopt;
    return clamped(written, given->second, least, most);
  }

  std::optional<Vec3f> color(const char* key, const char* written, float most) {
    const auto given = source_.colors.find(key);
    if (given == source_.colors.end()) return std::nullopt;
    Vec3f result = given->second;
    for (int i = 0; i < 3; ++i) result[i] = clamped(written, result[i], 0, most);
    return result;
  }

  float clamped(const char* key, float value, float least, float most) {
    if (value >= least && value <= most) return value;
    warn(fmt::format("{} is {}, brought into {} to {}", key, value, least, most));
    return value > most ? most : least;
  }

  void warn(const std::string& what) {
    warnings_.push_back(
        fmt::format("{}: material {}: {}", source_.file.string(), quote(source_.name), what));
  }

  const MtlMaterial& source_;
  Warnings& warnings_;
  int illum_;
};

}  // namespace

Material grey_material(const std::string& name) {
  Material result;
  result.name = name;
  result.base_color.value = Vec3f(default_grey);
  result.metallic.value = 0;
  result.double_sided = true;
  return result;
}

Material material_from_mtl(const MtlMaterial& source, Warnings& warnings) {
  return Converter(source, warnings).convert();
}

}  // namespace restframe

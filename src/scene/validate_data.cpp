#include "scene/validate_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/material_properties.h"

namespace restframe {
namespace {

using Faults = std::vector<std::string>;

bool is_usable(const Vec3f& position) {
  return is_within(position, static_cast<float>(largest_coordinate));
}

template <class T>
void check_attribute(const Mesh& mesh, const std::vector<T>& values, const std::string& what,
                     Faults& faults) {
  if (values.empty() || values.size() == mesh.positions.size()) return;
  faults.push_back(fmt::format("mesh \"{}\" has {} {} for {} vertices", mesh.name, values.size(),
                               what, mesh.positions.size()));
}

void check_ranges(const Mesh& mesh, Faults& faults) {
  const std::string name = fmt::format("mesh \"{}\"", mesh.name);
  const auto later = [](const MaterialRange& a, const MaterialRange& b) {
    return a.first_triangle < b.first_triangle;
  };
  if (mesh.materials.empty() || mesh.materials.front().first_triangle != 0) {
    faults.push_back(name + " has no material range that begins at triangle 0");
  } else if (!std::is_sorted(mesh.materials.begin(), mesh.materials.end(), later)) {
    faults.push_back(name + " has material ranges out of order");
  }
}

void check_function(const Scene& scene, FunctionIndex function, const std::string& what,
                    Faults& faults) {
  if (function >= no_function && function < static_cast<int>(scene.functions.size())) return;
  faults.push_back(fmt::format("{} refers to temporal function {} of {}", what, function,
                               scene.functions.size()));
}

std::string text_of(const Allowed& allowed) {
  if (allowed.high < std::numeric_limits<float>::max()) {
    return fmt::format("from {} to {}", allowed.low, allowed.high);
  }
  if (allowed.low <= -std::numeric_limits<float>::max()) return "finite";
  return fmt::format("at least {} and finite", allowed.low);
}

void check_texture(const Scene& scene, const TextureUse& use, const std::string& what,
                   Faults& faults) {
  if (use.texture < -1 || use.texture >= static_cast<int>(scene.textures.size())) {
    faults.push_back(
        fmt::format("{} refers to texture {} of {}", what, use.texture, scene.textures.size()));
  }
  if (use.uv_set < 0) {
    faults.push_back(fmt::format("{} uses UV set {}, must be 0 or more", what, use.uv_set));
  }
  for (const Vec2f& v : {use.transform.along_u, use.transform.along_v, use.transform.offset}) {
    if (std::isfinite(v.x) && std::isfinite(v.y)) continue;
    faults.push_back(what + " has a transform that is not finite");
    break;
  }
}

}  // namespace

void validate_number(const Scene& scene, const TemporalNumber& number, const std::string& what,
                     Faults& faults, const Allowed& allowed) {
  check_function(scene, number.function, what, faults);
  if (number.value >= allowed.low && number.value <= allowed.high) return;
  faults.push_back(fmt::format("{} is {}, must be {}", what, number.value, text_of(allowed)));
}

void validate_color(const Scene& scene, const TemporalColor& color, const std::string& what,
                    Faults& faults, const Allowed& allowed) {
  check_function(scene, color.function, what, faults);
  const Vec3f& v = color.value;
  const auto good = [&](float x) { return x >= allowed.low && x <= allowed.high; };
  if (good(v.x) && good(v.y) && good(v.z)) return;
  faults.push_back(
      fmt::format("{} is [{}, {}, {}], must be {}", what, v.x, v.y, v.z, text_of(allowed)));
}

void validate_mesh(const Mesh& mesh, Faults& faults) {
  const std::string name = fmt::format("mesh \"{}\"", mesh.name);
  const auto bad = std::find_if_not(mesh.positions.begin(), mesh.positions.end(), is_usable);
  if (bad != mesh.positions.end()) {
    faults.push_back(fmt::format("{} vertex {} is at [{}, {}, {}], must be finite and within 1e15",
                                 name, bad - mesh.positions.begin(), bad->x, bad->y, bad->z));
  }
  const auto outside =
      std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& corners) {
        return *std::max_element(corners.begin(), corners.end()) >= mesh.positions.size();
      });
  if (outside != mesh.triangles.end()) {
    faults.push_back(fmt::format("{} triangle {} refers to a vertex beyond its {}", name,
                                 outside - mesh.triangles.begin(), mesh.positions.size()));
  }
  check_attribute(mesh, mesh.normals, "normals", faults);
  check_attribute(mesh, mesh.tangents, "tangents", faults);
  if (!mesh.tangents.empty() && mesh.normals.empty()) {
    faults.push_back(name + " has tangents but no normals");
  }
  for (std::size_t set = 0; set < mesh.uvs.size(); ++set) {
    check_attribute(mesh, mesh.uvs[set], fmt::format("texture coordinates (set {})", set), faults);
  }
  check_attribute(mesh, mesh.colors, "colours", faults);
  check_ranges(mesh, faults);
}

void validate_materials(const Scene& scene, Faults& faults) {
  for (const Material& material : scene.materials) {
    const std::string name = fmt::format("material \"{}\": ", material.name);
    for (const NumberProperty& p : number_properties) {
      validate_number(scene, material.*p.member, name + p.name, faults, {p.low, p.high});
    }
    for (const ColorProperty& p : color_properties) {
      validate_color(scene, material.*p.member, name + p.name, faults, {0, p.high});
    }
    validate_spectrum(scene, material.emission_temperature, material.emission_spectrum,
                      name + "emission", faults);
    for (const TextureProperty& p : texture_properties) {
      check_texture(scene, material.*p.member, name + p.name, faults);
    }
    if (!std::isfinite(material.alpha_cutoff))
      faults.push_back(name + "alpha_cutoff is not finite");
    if (!std::isfinite(material.clearcoat_normal_scale))
      faults.push_back(name + "clearcoat_normal_scale is not finite");
  }
}

void validate_textures(const Scene& scene, Faults& faults) {
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const int image = scene.textures[i].image;
    if (image >= 0 && image < static_cast<int>(scene.images.size())) continue;
    faults.push_back(
        fmt::format("texture {} refers to image {} of {}", i, image, scene.images.size()));
  }
  for (const Image& image : scene.images) {
    const bool positive = image.width > 0 && image.height > 0;
    const std::size_t bytes = positive ? std::size_t{4} * image.width * image.height : 0;
    if (positive && image.rgba.size() == bytes) continue;
    faults.push_back(fmt::format("image \"{}\" has {} bytes for {} x {} pixels", image.name,
                                 image.rgba.size(), image.width, image.height));
  }
}

}  // namespace restframe

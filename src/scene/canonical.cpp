#include "scene/canonical.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <span>

#include "scene/canonical_listing.h"
#include "scene/material_properties.h"

namespace restframe {
namespace {

// XXH3 over plain values.
class Digest {
 public:
  template <class T>
  void add(std::span<const T> values) {
    hash_ = XXH3_64bits_withSeed(values.data(), values.size_bytes(), hash_);
  }
  template <class T>
  void add(std::span<T> values) {
    add(std::span<const T>(values));
  }
  std::string hex() const { return fmt::format("{:016x}", hash_); }

 private:
  XXH64_hash_t hash_ = 0;
};

// Assets are told by their files; generated meshes only by this.
void add_meshes(Listing& list, const std::vector<Mesh>& meshes) {
  Digest digest;
  for (const Mesh& mesh : meshes) {
    digest.add(std::span(mesh.positions));
    digest.add(std::span(mesh.triangles));
    digest.add(std::span(mesh.normals));
    digest.add(std::span(mesh.tangents));
    for (const std::vector<Vec2f>& uvs : mesh.uvs) digest.add(std::span(uvs));
    digest.add(std::span(mesh.colors));
    for (const MaterialRange& range : mesh.materials) {
      digest.add(std::span(&range.first_triangle, 1));
      digest.add(std::span(&range.slot, 1));
    }
  }
  list.add("meshes", fmt::format("{} {}", meshes.size(), digest.hex()));
}

std::string text_of(const std::optional<double>& period) {
  return period ? fmt::format("period {:.17g}", *period) : "once";
}

std::string text_of(const TemporalValue& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}

std::string text_of(const TemporalFunction& function) {
  if (const auto* intervals = std::get_if<IntervalFunction>(&function)) {
    std::string text = text_of(intervals->period);
    for (const auto& i : intervals->intervals) {
      text += fmt::format("; [{:.17g}, {:.17g}) {}", i.begin, i.end, text_of(i.value));
    }
    return text;
  }
  if (const auto* keys = std::get_if<KeyFunction>(&function)) {
    std::string text = text_of(keys->period);
    for (const auto& key : keys->keys)
      text += fmt::format("; {:.17g} {}", key.time, text_of(key.value));
    return text;
  }
  const auto& formula = std::get<FormulaFunction>(function);
  std::string text = "formula";
  for (const std::string& f : formula.formulas) text += "; " + f;
  if (formula.from) text += "; from " + text_of(*formula.from);
  if (formula.to) text += "; to " + text_of(*formula.to);
  return text;
}

void add_number(Listing& list, const std::string& key, const TemporalNumber& n) {
  list.add(key, fmt::format("{} function {}", n.value, n.function));
}

void add_color(Listing& list, const std::string& key, const TemporalColor& c) {
  list.add(key, fmt::format("{} function {}", text_of(c.value), c.function));
}

std::string text_of(const Vec2f& v) {
  return fmt::format("{} {}", v.x, v.y);
}

std::string text_of(const TextureUse& use) {
  const UvTransform& t = use.transform;
  return fmt::format("{} uv {} transform {} {} {}", use.texture, use.uv_set, text_of(t.along_u),
                     text_of(t.along_v), text_of(t.offset));
}

void add_spectrum(Listing& list, const EmissionSpectrum& spectrum, const std::string& key) {
  if (spectrum.empty()) return;
  std::string text;
  for (const SpectrumPoint& p : spectrum.points)
    text += fmt::format("{} {}; ", p.wavelength, p.value);
  for (const EmissionLine& line : spectrum.lines) {
    text += fmt::format("line {} {} {}; ", line.wavelength, line.power, line.width);
  }
  list.add(key, text);
}

void add_material(Listing& list, const Material& m, const std::string& key) {
  list.add(key + ".name", m.name);
  if (!m.group.empty()) list.add(key + ".group", m.group);
  for (const NumberProperty& property : number_properties) {
    add_number(list, fmt::format("{}.{}", key, property.name), m.*property.member);
  }
  for (const ColorProperty& property : color_properties) {
    add_color(list, fmt::format("{}.{}", key, property.name), m.*property.member);
  }
  add_number(list, key + ".emission_temperature", m.emission_temperature);
  add_spectrum(list, m.emission_spectrum, key + ".emission_spectrum");
  for (const TextureProperty& property : texture_properties) {
    const TextureUse& use = m.*property.member;
    if (use.texture >= 0) list.add(fmt::format("{}.{}", key, property.name), text_of(use));
  }
  list.add(key + ".flags",
           fmt::format("{} {} {} {} {} {}", static_cast<int>(m.alpha_mode), m.alpha_cutoff,
                       m.double_sided, m.unlit, m.thin_walled, m.clearcoat_normal_scale));
}

// What the images show is told by the assets' files.
void add_texture(Listing& list, const Texture& t, const std::string& key) {
  list.add(key, fmt::format("image {} {} wrap {} {} filter {} {} {}", t.image,
                            t.srgb ? "srgb" : "linear", static_cast<int>(t.wrap_u),
                            static_cast<int>(t.wrap_v), static_cast<int>(t.filter),
                            static_cast<int>(t.shrunken_filter), static_cast<int>(t.mip_filter)));
}

void add_object(Listing& list, const Object& object, const std::string& key) {
  list.add(key + ".name", object.name);
  add_worldline(list, key, object.worldline);
  list.add(key + ".clock", object.frame_clock ? "frame" : fmt::format("{:.17g}", object.clock));
  Digest parts;
  for (const PlacedMesh& part : object.parts) {
    parts.add(std::span(&part.mesh, 1));
    parts.add(std::span(&part.object_from_mesh, 1));
  }
  list.add(key + ".parts", fmt::format("{} {}", object.parts.size(), parts.hex()));
  std::string materials;
  for (const int m : object.materials) materials += fmt::format("{} ", m);
  list.add(key + ".materials", materials);
}

// What the layers that are asked for call the parts of objects.
void add_matte_names(Listing& list, const Scene& scene) {
  const std::vector<Layer>& layers = scene.output.layers;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const std::string key = fmt::format("object.{}", i);
    if (has_layer(layers, Layer::crypto_asset) && !object.whole.empty())
      list.add(key + ".whole", object.whole);
    if (!has_layer(layers, Layer::crypto_object) || object.part_names.empty()) continue;
    Digest names;
    for (const std::string& name : object.part_names) {
      names.add(std::span(name.c_str(), name.size() + 1));
    }
    for (const PlacedMesh& part : object.parts) names.add(std::span(&part.name, 1));
    list.add(key + ".part_names", fmt::format("{} {}", object.part_names.size(), names.hex()));
  }
}

// Its name is in no picture; its group names a layer.
void add_light(Listing& list, const Light& light, const std::string& key) {
  list.add(key + ".kind", static_cast<int>(light.kind));
  list.add(key + ".group", light.group);
  add_worldline(list, key, light.worldline);
  list.add(key + ".clock", light.frame_clock ? "frame" : fmt::format("{:.17g}", light.clock));
  list.add(key + ".direction", light.direction);
  list.add(key + ".cone", fmt::format("{:.17g} {:.17g}", light.inner_cone, light.outer_cone));
  if (light.sweep) {
    list.add(key + ".sweep.axis", light.sweep->axis);
    list.add(key + ".sweep.period", light.sweep->period);
  }
  add_color(list, key + ".color", light.color);
  add_number(list, key + ".intensity", light.intensity);
  add_number(list, key + ".temperature", light.temperature);
  add_spectrum(list, light.spectrum, key + ".spectrum");
  if (light.sky_map < 0) return;
  list.add(key + ".sky_map", light.sky_map);
  for (int i = 0; i < 3; ++i) {
    list.add(fmt::format("{}.rest_from_map.{}", key, i), light.rest_from_map[i]);
  }
}

void add_sky_map(Listing& list, const SkyMap& map, const std::string& key) {
  Digest digest;
  digest.add(std::span(map.pixels));
  list.add(key, fmt::format("{} {} {}", map.width, map.height, digest.hex()));
}

void add_exposure(Listing& list, const ExposureSettings& exposure) {
  list.add("exposure.shutter", exposure.shutter);
  std::string opening = fmt::format("{}", static_cast<int>(exposure.shape));
  for (const auto& [x, openness] : exposure.curve) {
    opening += fmt::format("; {:.17g} {:.17g}", x, openness);
  }
  list.add("exposure.opening", opening);
  list.add("exposure.count", exposure.count);
  list.add("exposure.interval", exposure.interval);
  list.add("exposure.combine", static_cast<int>(exposure.combine));
}

std::string text_of(const PixelWindow& window) {
  return fmt::format("{} {} {} {}", window.left, window.top, window.width, window.height);
}

std::string text_of(const std::vector<Layer>& layers) {
  std::string text;
  for (const Layer layer : layers) text += fmt::format("{} ", static_cast<int>(layer));
  return text;
}

void add_output(Listing& list, const OutputSettings& output) {
  list.add("output.layers", text_of(output.layers));
  list.add("output.half", text_of(output.half_layers));
  list.add("output.float", text_of(output.float_layers));
  list.add("output.compression", static_cast<int>(output.compression));
  list.add("output.compression_level", output.compression_level);
  list.add("output.split", output.split ? "true" : "false");
}

}  // namespace

std::string canonical_settings(const Scene& scene) {
  Listing list;
  list.add("scene.light_speed", scene.light_speed);
  add_camera(list, scene.camera);
  list.add("animation.rate", scene.animation.rate);
  list.add("animation.start", scene.animation.start);
  add_exposure(list, scene.exposure);
  list.add("render.resolution", fmt::format("{} {}", scene.render.width, scene.render.height));
  list.add("render.overscan", scene.render.overscan);
  list.add("render.window", text_of(picture_window(scene.render)));
  list.add("render.samples", scene.render.samples);
  list.add("render.noise", scene.render.noise);
  list.add("render.integrator", static_cast<int>(scene.render.integrator));
  list.add("render.depth", scene.render.depth);
  list.add("render.beaming", scene.render.beaming ? "true" : "false");
  list.add("render.doppler", scene.render.doppler ? "true" : "false");
  if (const auto& band = scene.render.observe) {
    list.add("render.observe", fmt::format("{:.17g} {:.17g}", band->from, band->to));
  }
  list.add("render.seed", fmt::format("{}", scene.render.seed));
  add_output(list, scene.output);
  add_meshes(list, scene.meshes);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    add_object(list, scene.objects[i], fmt::format("object.{}", i));
  }
  add_matte_names(list, scene);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    add_light(list, scene.lights[i], fmt::format("light.{}", i));
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    add_material(list, scene.materials[i], fmt::format("material.{}", i));
  }
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    add_texture(list, scene.textures[i], fmt::format("texture.{}", i));
  }
  for (std::size_t i = 0; i < scene.sky_maps.size(); ++i) {
    add_sky_map(list, scene.sky_maps[i], fmt::format("sky_map.{}", i));
  }
  for (std::size_t i = 0; i < scene.functions.size(); ++i) {
    list.add(fmt::format("function.{}", i), text_of(scene.functions[i]));
  }
  return std::move(list).text();
}

}  // namespace restframe

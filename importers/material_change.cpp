#include "importers/material_change.h"

#include "importers/scene_file_spectrum.h"

namespace restframe {

void set(const std::optional<Property>& given, TemporalNumber& number) {
  if (!given) return;
  if (const auto* constant = std::get_if<TemporalValue>(&*given)) number = {constant->x};
  if (const auto* function = std::get_if<FunctionIndex>(&*given)) number.function = *function;
}

void set(const std::optional<Property>& given, TemporalColor& color) {
  if (!given) return;
  if (const auto* constant = std::get_if<TemporalValue>(&*given)) color = {*constant};
  if (const auto* function = std::get_if<FunctionIndex>(&*given)) color.function = *function;
}

bool matches(std::string_view pattern, std::string_view name) {
  // Upon a mismatch the last * takes one character more.
  std::size_t p = 0, n = 0, star = std::string_view::npos, taken = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

void apply(const MaterialChange& change, Material& material) {
  bool opacity_given = false;
  for (const auto& [member, property] : change.numbers) {
    set(property, material.*member);
    opacity_given |= member == &Material::opacity;
  }
  set(change.spectrum, material.emission_temperature, material.emission_spectrum);
  if (change.spectrum.any()) material.emission = {Vec3f(1)};
  for (const auto& [member, property] : change.colors) set(property, material.*member);
  if (change.base_color_texture == false) material.base_color_texture = {};
  if (change.thin_walled) material.thin_walled = *change.thin_walled;
  if (change.unlit) material.unlit = *change.unlit;
  if (change.group) material.group = *change.group;
  const bool see_through = material.opacity.function != no_function || material.opacity.value < 1;
  if (opacity_given && see_through && material.alpha_mode == AlphaMode::opaque) {
    material.alpha_mode = AlphaMode::blend;
  }
}

}  // namespace restframe

#include "importers/material_change.h"

namespace restframe {
namespace {

void set(const std::optional<Property>& change, TemporalNumber& number) {
  if (!change) return;
  if (const auto* constant = std::get_if<TemporalValue>(&*change)) number = {constant->x};
  if (const auto* function = std::get_if<FunctionIndex>(&*change)) number.function = *function;
}

void set(const std::optional<Property>& change, TemporalColor& color) {
  if (!change) return;
  if (const auto* constant = std::get_if<TemporalValue>(&*change)) color = {*constant};
  if (const auto* function = std::get_if<FunctionIndex>(&*change)) color.function = *function;
}

}  // namespace

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
  set(change.base_color, material.base_color);
  set(change.metallic, material.metallic);
  set(change.roughness, material.roughness);
  set(change.emission, material.emission);
  set(change.emission_strength, material.emission_strength);
  set(change.opacity, material.opacity);
  if (change.base_color_texture == false) material.base_color_texture = {};
  if (change.unlit) material.unlit = *change.unlit;
  const bool see_through = material.opacity.function != no_function || material.opacity.value < 1;
  if (change.opacity && see_through && material.alpha_mode == AlphaMode::opaque) {
    material.alpha_mode = AlphaMode::blend;
  }
}

}  // namespace restframe

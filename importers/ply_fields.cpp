#include "importers/ply_fields.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace restframe {
namespace {

struct Spelling {
  std::string_view name;
  PlyField field;
};

constexpr Spelling vertex_spellings[] = {
    {"x", PlyField::x},
    {"y", PlyField::y},
    {"z", PlyField::z},
    {"nx", PlyField::normal_x},
    {"ny", PlyField::normal_y},
    {"nz", PlyField::normal_z},
    {"normal_x", PlyField::normal_x},
    {"normal_y", PlyField::normal_y},
    {"normal_z", PlyField::normal_z},
    {"u", PlyField::u},
    {"v", PlyField::v},
    {"s", PlyField::u},
    {"t", PlyField::v},
    {"texture_u", PlyField::u},
    {"texture_v", PlyField::v},
    {"texture_s", PlyField::u},
    {"texture_t", PlyField::v},
};

constexpr Spelling color_spellings[] = {
    {"red", PlyField::red},
    {"green", PlyField::green},
    {"blue", PlyField::blue},
    {"alpha", PlyField::alpha},
    {"diffuse_red", PlyField::red},
    {"diffuse_green", PlyField::green},
    {"diffuse_blue", PlyField::blue},
    {"diffuse_alpha", PlyField::alpha},
    {"r", PlyField::red},
    {"g", PlyField::green},
    {"b", PlyField::blue},
    {"a", PlyField::alpha},
};

constexpr Spelling list_spellings[] = {
    {"vertex_indices", PlyField::corners},
    {"vertex_index", PlyField::corners},
    {"texcoord", PlyField::corner_uvs},
};

template <std::size_t Count>
PlyField look_up(const Spelling (&spellings)[Count], const std::string& name) {
  for (const Spelling& spelling : spellings) {
    if (spelling.name == name) return spelling.field;
  }
  return PlyField::none;
}

bool has(const std::vector<PlyField>& fields, PlyField field) {
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

// Whether all are there; if not, those that are become none.
bool has_all(std::vector<PlyField>& fields, std::initializer_list<PlyField> wanted) {
  const bool all =
      std::all_of(wanted.begin(), wanted.end(), [&](PlyField field) { return has(fields, field); });
  if (all) return true;
  for (const PlyField field : wanted) {
    std::replace(fields.begin(), fields.end(), field, PlyField::none);
  }
  return false;
}

PlyFields complete(std::vector<PlyField> fields) {
  using F = PlyField;
  PlyFields result;
  result.has_position = has_all(fields, {F::x, F::y, F::z});
  result.has_normal = has_all(fields, {F::normal_x, F::normal_y, F::normal_z});
  result.has_uv = has_all(fields, {F::u, F::v});
  result.has_color = has_all(fields, {F::red, F::green, F::blue});
  result.has_alpha = result.has_color && has(fields, F::alpha);
  if (!result.has_color) std::replace(fields.begin(), fields.end(), F::alpha, F::none);
  result.has_corners = has(fields, F::corners);
  result.of_property = std::move(fields);
  return result;
}

template <class LookUp>
PlyFields find_fields(const PlyElement& element, const LookUp& look_up_field) {
  std::vector<PlyField> fields;
  for (const PlyProperty& property : element.properties) {
    const PlyField field = look_up_field(property);
    fields.push_back(has(fields, field) ? PlyField::none : field);
  }
  return complete(std::move(fields));
}

}  // namespace

PlyFields vertex_fields(const PlyElement& element) {
  return find_fields(element, [](const PlyProperty& property) {
    if (property.count_type) return PlyField::none;
    const PlyField color = look_up(color_spellings, property.name);
    return color != PlyField::none ? color : look_up(vertex_spellings, property.name);
  });
}

PlyFields face_fields(const PlyElement& element) {
  return find_fields(element, [](const PlyProperty& property) {
    if (property.count_type) return look_up(list_spellings, property.name);
    return look_up(color_spellings, property.name);
  });
}

bool is_real(PlyType type) {
  return type == PlyType::float32 || type == PlyType::float64;
}

double color_scale(PlyType type) {
  constexpr double byte = 255, half_word = 65535;
  if (is_real(type)) return 1;
  return 1 / (size_of(type) == 2 ? half_word : byte);  // wider integers hold bytes
}

}  // namespace restframe

#include "importers/ply_body.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "importers/ply_fields.h"
#include "scene/message.h"

namespace restframe {
namespace {

// The numbers of a row that mean something, by field.
using Row = std::array<double, static_cast<std::size_t>(PlyField::none) + 1>;

double at(const Row& row, PlyField field) {
  return row[static_cast<std::size_t>(field)];
}

float real(double x) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::isnan(x) ? x : std::fmin(std::fmax(x, -largest), largest));
}

Vec3f vector(const Row& row, PlyField x, PlyField y, PlyField z) {
  return {real(at(row, x)), real(at(row, y)), real(at(row, z))};
}

Vec4f color(const Row& row, bool has_alpha) {
  return {vector(row, PlyField::red, PlyField::green, PlyField::blue),
          has_alpha ? real(at(row, PlyField::alpha)) : std::numeric_limits<float>::infinity()};
}

bool is_color(PlyField field) {
  return field >= PlyField::red && field <= PlyField::alpha;
}

// Reads element after element; `Values` is PlyText or PlyBytes.
template <class Values>
class BodyReader {
 public:
  BodyReader(Values& values, const PlyHeader& header, MeshBuilder& builder)
      : values_(values), header_(header), builder_(builder) {}

  std::vector<std::string> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        read_faces(element, element.name == "tristrips");
      } else {
        if (element.count > 0) unused_.push_back(element.name);
        skip(element);
      }
    }
    if (!values_.at_end()) unused_.emplace_back("what follows the last element");
    return std::move(unused_);
  }

 private:
  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) skip(property);
    }
  }

  void skip(const PlyProperty& property) {
    values_.skip(property.type, property.count_type ? read_count(*property.count_type) : 1);
  }

  std::uint64_t read_count(PlyType type) {
    const double count = values_.next(type);
    constexpr double most = 4294967295.0;
    if (count >= 0 && count <= most && count == std::floor(count)) {
      return static_cast<std::uint64_t>(count);
    }
    values_.fail(fmt::format("a list of {} items", count));
  }

  void note_unused(const PlyElement& element, const PlyFields& fields) {
    for (std::size_t i = 0; i < fields.of_property.size(); ++i) {
      if (fields.of_property[i] != PlyField::none) continue;
      unused_.push_back(element.name + "." + element.properties[i].name);
    }
  }

  // Whether numbers of a colour beyond 1 may mean 0 to 255.
  void note_colors(const PlyElement& element, const PlyFields& fields) {
    for (std::size_t i = 0; i < fields.of_property.size(); ++i) {
      const PlyField field = fields.of_property[i];
      if (!is_color(field) || !is_real(element.properties[i].type)) continue;
      (field == PlyField::alpha ? builder_.alpha_may_be_bytes : builder_.rgb_may_be_bytes) = true;
    }
  }

  // Numbers of colours come within 0..1, but for those that are floating point.
  void read_row(const PlyElement& element, const PlyFields& fields, Row& row) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const PlyField field = fields.of_property[i];
      if (field == PlyField::none) {
        skip(property);
      } else if (field == PlyField::corners) {
        read_corners(property);
      } else if (field == PlyField::corner_uvs) {
        read_corner_uvs(property);
      } else {
        const double number = values_.next(property.type);
        row[static_cast<std::size_t>(field)] =
            is_color(field) ? color_scale(property.type) * number : number;
      }
    }
  }

  void read_vertices(const PlyElement& element) {
    const PlyFields fields = vertex_fields(element);
    if (!fields.has_position) builder_.fail("the vertices have no properties x, y and z");
    note_unused(element, fields);
    note_colors(element, fields);
    has_vertex_colors_ = fields.has_color;
    builder_.expect_vertices(element.count, sizeof(Vec3f) * 2 + sizeof(Vec4f) + sizeof(Vec2f));
    Mesh& mesh = builder_.mesh;
    Row row{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_row(element, fields, row);
      mesh.positions.push_back(vector(row, PlyField::x, PlyField::y, PlyField::z));
      if (fields.has_normal) {
        mesh.normals.push_back(
            vector(row, PlyField::normal_x, PlyField::normal_y, PlyField::normal_z));
      }
      if (fields.has_color) mesh.colors.push_back(color(row, fields.has_alpha));
      if (fields.has_uv) {  // PLY's v points up
        mesh.uvs[0].emplace_back(real(at(row, PlyField::u)), real(1 - at(row, PlyField::v)));
      }
    }
  }

  void read_faces(const PlyElement& element, bool strips) {
    if (builder_.mesh.positions.empty() && element.count > 0) {
      builder_.fail(fmt::format("element {} before any vertices", quote(element.name)));
    }
    PlyFields fields = face_fields(element);
    if (!fields.has_corners) {
      builder_.fail(fmt::format("element {} has no list vertex_indices", quote(element.name)));
    }
    keep_needed(fields, strips);
    note_unused(element, fields);
    if (fields.has_color) note_colors(element, fields);
    allows_restart_ = strips;
    Row row{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      attributes_.uvs.clear();
      read_row(element, fields, row);
      if (fields.has_color) attributes_.color = color(row, fields.has_alpha);
      if (attributes_.uvs.size() != corners_.size()) attributes_.uvs.clear();
      strips ? add_strips() : builder_.add_face(corners_, attributes_);
    }
  }

  // A vertex's own colour holds; and a strip has but corners.
  void keep_needed(PlyFields& fields, bool strips) const {
    const bool no_color = strips || has_vertex_colors_;
    for (PlyField& field : fields.of_property) {
      if (no_color && is_color(field)) field = PlyField::none;
      if (strips && field == PlyField::corner_uvs) field = PlyField::none;
    }
    if (no_color) fields.has_color = false;
  }

  void read_corners(const PlyProperty& property) {
    const std::uint64_t count = read_count(*property.count_type);
    corners_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const double index = values_.next(property.type);
      if (allows_restart_ && index == -1) {
        corners_.push_back(restart);
        continue;
      }
      const std::string fault = builder_.index_fault(index);
      if (!fault.empty()) values_.fail(fault);
      if (index != std::floor(index)) values_.fail(fmt::format("{} is no vertex index", index));
      corners_.push_back(static_cast<std::uint32_t>(index));
    }
  }

  // u and v of each corner in turn.
  void read_corner_uvs(const PlyProperty& property) {
    const std::uint64_t count = read_count(*property.count_type);
    for (std::uint64_t i = 0; i + 1 < count; i += 2) {
      const double u = values_.next(property.type), v = values_.next(property.type);
      attributes_.uvs.emplace_back(real(u), real(1 - v));
    }
    if (count % 2 != 0) values_.skip(property.type, 1);
  }

  // Each corner after the first two of a strip makes a triangle with those before, every second one
  // turned over.
  void add_strips() {
    std::vector<std::uint32_t> triangle(3);
    std::size_t length = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      length = corners_[i] == restart ? 0 : length + 1;
      if (length < 3) continue;
      const std::size_t odd = (length - 3) % 2;
      triangle = {corners_[i - 2 + odd], corners_[i - 1 - odd], corners_[i]};
      builder_.add_face(triangle);
    }
  }

  static constexpr std::uint32_t restart = 0xFFFFFFFFU;

  Values& values_;
  const PlyHeader& header_;
  MeshBuilder& builder_;
  std::vector<std::string> unused_;
  std::vector<std::uint32_t> corners_;
  FaceAttributes attributes_;
  bool allows_restart_ = false, has_vertex_colors_ = false;
};

}  // namespace

std::vector<std::string> read_ply_body(PlyText& values, const PlyHeader& header,
                                       MeshBuilder& builder) {
  return BodyReader<PlyText>(values, header, builder).read();
}

std::vector<std::string> read_ply_body(PlyBytes& values, const PlyHeader& header,
                                       MeshBuilder& builder) {
  return BodyReader<PlyBytes>(values, header, builder).read();
}

}  // namespace restframe

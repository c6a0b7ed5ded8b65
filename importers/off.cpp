#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "importers/mesh_asset.h"
#include "importers/mesh_builder.h"
#include "importers/off_header.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Reads the lines after the header: one a vertex, one a face.
class OffBody {
 public:
  OffBody(TextWords& words, const OffHeader& header, MeshBuilder& builder)
      : words_(words), header_(header), builder_(builder) {}

  void read() {
    builder_.rgb_may_be_bytes = builder_.alpha_may_be_bytes = true;
    for (std::uint64_t i = 0; i < header_.vertices; ++i) read_vertex(i);
    for (std::uint64_t i = 0; i < header_.faces; ++i) read_face(i);
  }

  void warn(const std::string& file, Warnings& warnings) const {
    const auto add = [&](std::uint64_t count, const char* what) {
      if (count > 0) warnings.push_back(fmt::format("{}: {} {}", file, count, what));
    };
    add(vertices_with_more_, "vertices have numbers that the header does not announce, not used");
    add(faces_with_more_,
        "faces have colours that are no RGB or RGBA, or go after those of vertices, not used");
    if (words_.next_line()) warnings.push_back(file + ": lines after the last face are not used");
  }

 private:
  void start_line(const char* what, std::uint64_t index, std::uint64_t count) {
    if (words_.next_line()) return;
    words_.fail_at_end(fmt::format("{} {} of {} is missing", what, index, count));
  }

  // The rest of the line.
  void read_numbers() {
    numbers_.clear();
    for (auto word = words_.next_on_line(); !word.empty(); word = words_.next_on_line()) {
      numbers_.push_back(words_.real(word));
      last_word_ = word;
    }
  }

  void read_vertex(std::uint64_t index) {
    start_line("vertex", index, header_.vertices);
    read_numbers();
    const std::size_t least = 3 + (header_.has_weight ? 1 : 0) + (header_.has_normals ? 3 : 0) +
                              (header_.has_colors ? 3 : 0) + (header_.has_uvs ? 2 : 0);
    if (numbers_.size() < least) {
      words_.fail(last_word_, fmt::format("vertex {} ends here, after {} numbers, must have {}",
                                          index, numbers_.size(), least));
    }
    const bool has_alpha = header_.has_colors && numbers_.size() > least;
    if (numbers_.size() > least + (has_alpha ? 1 : 0)) ++vertices_with_more_;
    add_vertex(has_alpha);
  }

  // In this order: position, normal, colour, texture coordinates.
  void add_vertex(bool has_alpha) {
    Mesh& mesh = builder_.mesh;
    const float* next = numbers_.data();
    const auto take = [&next] { return *next++; };
    const auto take_vector = [&next] {
      next += 3;
      return Vec3f(next[-3], next[-2], next[-1]);
    };
    mesh.positions.push_back(take_vector());
    if (header_.has_weight) mesh.positions.back() /= take();
    if (header_.has_normals) mesh.normals.push_back(take_vector());
    if (header_.has_colors) {
      const Vec3f rgb = take_vector();
      mesh.colors.emplace_back(rgb, has_alpha ? take() : 1.0F);
    }
    if (header_.has_uvs) {
      const float u = take(), v = take();
      mesh.uvs[0].emplace_back(u, 1 - v);  // OFF's v points up
    }
  }

  void read_face(std::uint64_t index) {
    start_line("face", index, header_.faces);
    const std::string_view word = words_.next_on_line();
    const double count = words_.number(word);
    if (!(count >= 0 && count <= most_corners && count == std::floor(count))) {
      words_.fail(word, fmt::format("{} is no number of corners", quote(word)));
    }
    corners_.clear();
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) read_corner(word);
    read_numbers();
    FaceAttributes attributes;
    const bool is_color = numbers_.size() == 3 || numbers_.size() == 4;
    if (is_color && !header_.has_colors) {
      const float alpha = numbers_.size() == 4 ? numbers_[3] : opaque;
      attributes.color = Vec4f(numbers_[0], numbers_[1], numbers_[2], alpha);
    }
    if (!attributes.color && !numbers_.empty()) ++faces_with_more_;
    builder_.add_face(corners_, attributes);
  }

  void read_corner(std::string_view count) {
    const std::string_view word = words_.next_on_line();
    if (word.empty()) {
      words_.fail(count, fmt::format("a face of {} corners ends after {}", count, corners_.size()));
    }
    const double index = words_.number(word);
    std::string fault = builder_.index_fault(index);
    if (fault.empty() && index != std::floor(index)) {
      fault = quote(word) + " is no vertex index";
    }
    if (!fault.empty()) words_.fail(word, fault);
    corners_.push_back(static_cast<std::uint32_t>(index));
  }

  // Whether others have an alpha from 0 to 1 or to 255.
  static constexpr float opaque = std::numeric_limits<float>::infinity();
  static constexpr double most_corners = 4e9;

  TextWords& words_;
  const OffHeader& header_;
  MeshBuilder& builder_;
  std::string_view last_word_;
  std::vector<float> numbers_;
  std::vector<std::uint32_t> corners_;
  std::uint64_t vertices_with_more_ = 0, faces_with_more_ = 0;
};

}  // namespace

Asset load_off(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  TextFile file(path, limits.total_bytes);
  TextWords words(file, '#');
  const OffHeader header = read_off_header(words, file.text().size());
  MeshBuilder builder(path.string(), limits);
  builder.expect_vertices(header.vertices, sizeof(Vec3f) * 2 + sizeof(Vec4f) + sizeof(Vec2f));
  OffBody body(words, header, builder);
  body.read();
  body.warn(path.string(), warnings);
  std::vector<Mesh> meshes(1);
  meshes[0] = builder.take(warnings);
  return make_mesh_asset(path, std::move(meshes), warnings);
}

}  // namespace restframe

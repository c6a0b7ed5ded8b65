#include <fmt/format.h>

#include <cctype>

#include "importers/stl_solid.h"
#include "importers/text_words.h"
#include "importers/triangulate.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Reads solid after solid: `solid NAME`, facets, `endsolid NAME`.
class StlText {
 public:
  StlText(const Path& path, const ImportLimits& limits)
      : file_(path, limits.total_bytes), words_(file_), limits_(limits) {}

  std::vector<Mesh> read(Warnings& warnings) {
    std::vector<Mesh> solids;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      check(word, "solid");
      const std::string name = on_one_line(std::string(words_.rest_of_line()));
      read_facets();
      if (solid_.empty()) {
        ++empty_;
        continue;
      }
      if (solids.size() >= limits_.nodes) {
        words_.fail(word, fmt::format("more than {} solids, the limit", limits_.nodes));
      }
      solids.push_back(solid_.take(name));
      solid_ = {};
    }
    warn(warnings);
    if (solids.empty()) throw InputError(file_.path().string() + ": nothing to render: no facets");
    return solids;
  }

 private:
  void check(std::string_view word, std::string_view wanted) {
    if (word.empty()) words_.fail_at_end(fmt::format("\"{}\" is missing", wanted));
    if (lower(word) == wanted) return;
    words_.fail(word, fmt::format("{}, must be \"{}\"", quote(word), wanted));
  }

  void expect(std::string_view wanted) { check(words_.next(), wanted); }

  void read_facets() {
    for (;;) {
      const std::string_view word = words_.next();
      if (lower(word) == "endsolid") {
        words_.rest_of_line();
        return;
      }
      if (word.empty()) words_.fail_at_end("\"endsolid\" is missing");
      if (lower(word) != "facet") {
        words_.fail(word, fmt::format("{}, must be \"facet\" or \"endsolid\"", quote(word)));
      }
      read_facet(word);
    }
  }

  void read_facet(std::string_view word) {
    const std::string at = file_.position(word);
    expect("normal");
    read_vector();  // not needed: the corners' order says the same
    expect("outer");
    expect("loop");
    read_corners();
    expect("endfacet");
    if (corners_.size() < 3) {
      throw InputError(
          fmt::format("{}: a facet of {} corners, must be at least 3", at, corners_.size()));
    }
    triangles_ += corners_.size() - 2;
    if (triangles_ > limits_.triangles) {
      throw InputError(fmt::format("{}: more than {} triangles, the limit", at, limits_.triangles));
    }
    add_facet();
  }

  void read_corners() {
    corners_.clear();
    for (;;) {
      const std::string_view word = words_.next();
      if (lower(word) == "endloop") return;
      check(word, "vertex");
      const std::string at = file_.position(word);
      const Vec3f corner = read_vector();
      const std::string fault = corner_fault(corner);
      if (!fault.empty()) throw InputError(at + ": " + fault);
      corners_.emplace_back(corner);
    }
  }

  Vec3f read_vector() {
    Vec3f result;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = words_.next();
      if (word.empty()) words_.fail_at_end("a number is missing");
      result[i] = words_.real(word);
    }
    return result;
  }

  void add_facet() {
    pieces_.clear();
    cutter_.cut(corners_, pieces_);
    for (const Triangle& t : pieces_) {
      solid_.add({Vec3f(corners_[t[0]]), Vec3f(corners_[t[1]]), Vec3f(corners_[t[2]])});
    }
  }

  void warn(Warnings& warnings) const {
    if (empty_ > 0) {
      warnings.push_back(
          fmt::format("{}: {} solids without facets, skipped", file_.path().string(), empty_));
    }
    if (cutter_.exhausted()) {
      warnings.push_back(file_.path().string() +
                         ": polygons with too many concave corners were cut into fans");
    }
  }

  TextFile file_;
  TextWords words_;
  const ImportLimits& limits_;
  SolidBuilder solid_;
  PolygonCutter cutter_;
  std::vector<Vec3> corners_;
  std::vector<Triangle> pieces_;
  std::uint64_t triangles_ = 0, empty_ = 0;
};

}  // namespace

std::vector<Mesh> read_stl_text(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  return StlText(path, limits).read(warnings);
}

}  // namespace restframe

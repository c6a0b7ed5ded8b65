#include "importers/mtl_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

#include "importers/text_lines.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Rewrites an MTL file to what tinyobjloader reads without mistakes: only keys that are used,
// checked numbers, three for a colour, every material with a name of its own.
class MtlRewriter {
 public:
  MtlRewriter(TextFile& file, Warnings& warnings) : file_(file), warnings_(warnings) {}

  std::string run() {
    std::string_view line;
    while (file_.next_line(line)) add_line(line);
    if (!unused_.empty()) {
      const std::string list = fmt::format("{}", fmt::join(unused_, ", "));
      warnings_.push_back(
          on_one_line(fmt::format("{}: not used: {}", file_.path().string(), list)));
    }
    return std::move(text_);
  }

  std::vector<MtlMaterial> materials;  // without values

 private:
  void add_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view key = take_word(rest);
    if (key.empty() || key[0] == '#') return;
    if (key == "newmtl") {
      start_material(rest);
    } else if (materials.empty()) {
      file_.fail(key, fmt::format("{} before the first newmtl", quote(key)));
    } else if (key == "Kd" || key == "Ke") {
      add_color(key, rest);
    } else if (key == "d" || key == "Tr" || key == "Ns" || key == "Ni" || key == "Pr" ||
               key == "Pm") {
      add_number(key, rest);
    } else if (key == "map_Kd" || key == "map_Ke") {
      emit(key, trimmed(rest));
    } else {
      note_unused(key);
    }
  }

  void start_material(std::string_view rest) {
    constexpr std::size_t most = 100'000;
    if (materials.size() >= most) file_.fail(rest, fmt::format("more than {} materials", most));
    materials.push_back({std::string(trimmed(rest)), {}, {}, file_.path()});
    text_ += fmt::format("newmtl {}\n", materials.size());
  }

  void emit(std::string_view key, std::string_view value) {
    text_.append(key).append(" ").append(value).append("\n");
    materials.back().given.emplace(key);
  }

  void check_number(std::string_view word, std::string_view key) {
    double value = 0;
    if (word.empty()) file_.fail(key, fmt::format("{} without a number", key));
    if (!read_number(word, value)) file_.fail(word, number_fault(word));
  }

  // "r g b", or "r" for a grey.
  void add_color(std::string_view key, std::string_view rest) {
    const std::string_view r = take_word(rest), g = take_word(rest), b = take_word(rest);
    if (r == "spectral" || r == "xyz") {
      warnings_.push_back(
          fmt::format("{}: {} in terms of {} is not used", file_.position(r), key, r));
      return;
    }
    check_number(r, key);
    if (g.empty() || g[0] == '#') return emit(key, fmt::format("{} {} {}", r, r, r));
    check_number(g, key);
    check_number(b, key);
    emit(key, fmt::format("{} {} {}", r, g, b));
  }

  void add_number(std::string_view key, std::string_view rest) {
    std::string_view word = take_word(rest);
    if (word == "-halo") word = take_word(rest);
    check_number(word, key);
    emit(key, word);
  }

  void note_unused(std::string_view key) {
    constexpr std::size_t most = 16;
    if (unused_.size() < most) unused_.insert(key.size() > 24 ? quote(key) : std::string(key));
  }

  TextFile& file_;
  Warnings& warnings_;
  std::string text_;
  std::set<std::string> unused_;
};

}  // namespace

void read_mtl(const Path& path, const ImportLimits& limits, std::vector<MtlMaterial>& materials,
              Warnings& warnings) {
  TextFile file(path, limits.total_bytes);
  MtlRewriter rewriter(file, warnings);
  std::istringstream stream(rewriter.run());

  std::map<std::string, int> names;
  std::vector<tinyobj::material_t> values;
  std::string warning, error;
  tinyobj::LoadMtl(&names, &values, &stream, &warning, &error);
  for (std::size_t i = 0; i < rewriter.materials.size(); ++i) {
    rewriter.materials[i].values = std::move(values.at(i));
  }
  std::move(rewriter.materials.begin(), rewriter.materials.end(), std::back_inserter(materials));
}

}  // namespace restframe

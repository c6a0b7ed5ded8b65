#include "importers/mtl_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include "importers/line_reader.h"
#include "importers/mtl_map.h"
#include "importers/text_lines.h"
#include "scene/message.h"

namespace restframe {
namespace {

// Keys that have spellings of their own for the same.
const std::map<std::string, std::string, std::less<>>& map_keys() {
  static const std::map<std::string, std::string, std::less<>> keys = {
      {"map_kd", "kd"},     {"map_ke", "ke"},     {"map_ks", "ks"},    {"map_d", "d"},
      {"map_pr", "pr"},     {"map_pm", "pm"},     {"map_ps", "ps"},    {"map_pc", "pc"},
      {"map_pcr", "pcr"},   {"map_bump", "bump"}, {"bump", "bump"},    {"norm", "norm"},
      {"map_norm", "norm"}, {"map_kn", "norm"},   {"map_opacity", "d"}};
  return keys;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string in_lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

class MtlReader {
 public:
  MtlReader(const Path& path, const ImportLimits& limits, Warnings& warnings)
      : lines_(path, limits.total_bytes), warnings_(warnings) {}

  std::vector<MtlMaterial> run() {
    std::string_view line;
    while (lines_.next_line(line)) read_line(line);
    warn_of("not used", unused_);
    warn_of("texture options that are not used", unused_options_);
    return std::move(materials_);
  }

 private:
  void read_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view written = take_word(rest);
    if (written.empty() || written[0] == '#') return;
    const std::string key = in_lower_case(written);
    if (key == "newmtl") {
      start_material(rest);
    } else if (materials_.empty()) {
      lines_.fail(written, fmt::format("{} before the first newmtl", quote(written)));
    } else if (is_one_of(key, {"kd", "ks", "ke", "tf"})) {
      add_color(written, key, rest);
    } else if (is_one_of(key, {"d", "tr", "ns", "ni", "illum", "pr", "pm", "ps", "pc", "pcr"})) {
      add_number(written, key, rest);
    } else if (const auto map = map_keys().find(key); map != map_keys().end()) {
      materials_.back().maps[map->second] = read_mtl_map(written, rest, lines_, unused_options_);
    } else if (key != "ka") {  // ambient light stands in for light that is not traced
      note_unused(written);
    }
  }

  void start_material(std::string_view rest) {
    constexpr std::size_t most = 100'000;
    if (materials_.size() >= most) lines_.fail(rest, fmt::format("more than {} materials", most));
    materials_.push_back({std::string(trimmed(rest)), lines_.path(), {}, {}, {}});
  }

  float read(std::string_view word, std::string_view key) const {
    double value = 0;
    if (word.empty() || word[0] == '#') lines_.fail(key, fmt::format("{} without a number", key));
    if (!read_number(word, value)) lines_.fail(word, number_fault(word));
    constexpr double largest = 1e30;
    return static_cast<float>(std::clamp(value, -largest, largest));
  }

  // "r g b", or "r" for a grey.
  void add_color(std::string_view written, const std::string& key, std::string_view rest) {
    const std::string_view r = take_word(rest), g = take_word(rest), b = take_word(rest);
    if (r == "spectral" || r == "xyz") {
      warnings_.push_back(fmt::format("{}: {} in terms of {} is not used",
                                      lines_.position(lines_.place(r)), written, r));
      return;
    }
    Vec3f color(read(r, written));
    if (!g.empty() && g[0] != '#') color = Vec3f(color.r, read(g, written), read(b, written));
    materials_.back().colors[key] = color;
  }

  void add_number(std::string_view written, const std::string& key, std::string_view rest) {
    std::string_view word = take_word(rest);
    if (word == "-halo") {
      unused_.insert("d -halo");
      word = take_word(rest);
    }
    materials_.back().numbers[key] = read(word, written);
  }

  void note_unused(std::string_view key) {
    constexpr std::size_t most = 16;
    if (unused_.size() < most) unused_.insert(key.size() > 24 ? quote(key) : std::string(key));
  }

  void warn_of(const char* what, const std::set<std::string>& list) const {
    if (list.empty()) return;
    warnings_.push_back(
        fmt::format("{}: {}: {}", lines_.path().string(), what, fmt::join(list, ", ")));
  }

  LineReader lines_;
  Warnings& warnings_;
  std::vector<MtlMaterial> materials_;
  std::set<std::string> unused_, unused_options_;
};

}  // namespace

void read_mtl(const Path& path, const ImportLimits& limits, std::vector<MtlMaterial>& materials,
              Warnings& warnings) {
  std::vector<MtlMaterial> read = MtlReader(path, limits, warnings).run();
  std::move(read.begin(), read.end(), std::back_inserter(materials));
}

}  // namespace restframe

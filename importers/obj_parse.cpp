#include "importers/obj_parse.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <climits>
#include <map>
#include <set>
#include <utility>

#include "importers/line_reader.h"
#include "importers/obj_faces.h"
#include "importers/obj_vectors.h"
#include "importers/text_lines.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::size_t most_libraries = 1000;
constexpr std::size_t most_keywords = 16;  // unused ones that get a warning each

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const char* why_unused(std::string_view keyword) {
  if (keyword == "p") return "points are not renderable, skipped";
  if (keyword == "l") return "lines are not renderable, skipped";
  if (keyword == "s") return "must be a whole number or off, skipped";
  if (is_one_of(keyword, {"vp",   "cstype", "deg",  "bmat", "step", "curv", "curv2",
                          "surf", "parm",   "trim", "hole", "scrv", "sp",   "end",
                          "con",  "bzp",    "bsp",  "cdc",  "cdp",  "res"})) {
    return "free-form curves and surfaces are not read, skipped";
  }
  if (is_one_of(keyword, {"call", "csh"})) return "other files and commands are not followed";
  return "not used";
}

// Words with one space between them.
std::string joined_words(std::string_view rest) {
  std::string result;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    if (!result.empty()) result += ' ';
    result += word;
  }
  return result;
}

class ObjParser {
 public:
  ObjParser(const Path& path, const ImportLimits& limits)
      : lines_(path, limits.total_bytes), vectors_(lines_, data_), faces_(lines_, limits, data_) {
    reserve();
  }

  ObjData run(Warnings& warnings) {
    std::string_view line;
    while (lines_.next_line(line)) read_line(line);
    faces_.check_greatest();
    warn_of_unused(warnings);
    if (data_.triangles.empty()) {
      throw InputError(lines_.path().string() + ": nothing to render: no faces");
    }
    vectors_.finish_colors(warnings);
    finish_smoothing();
    return std::move(data_);
  }

 private:
  struct Unused {
    std::uint64_t lines = 0;
    LineReader::Place place;
  };

  // What files of common shapes need: memory that is never touched costs nothing, while arrays that
  // grow leave their old selves behind.
  void reserve() {
    constexpr std::size_t bytes_a_vertex = 100, bytes_a_triangle = 50;
    const std::size_t vertices = lines_.size() / bytes_a_vertex;
    data_.positions.reserve(vertices);
    data_.normals.reserve(vertices);
    data_.vertices.reserve_keys(vertices);
    data_.triangles.reserve(lines_.size() / bytes_a_triangle);
  }

  void read_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    if (keyword == "v") {
      vectors_.add_vertex(line, rest);
    } else if (keyword == "f" || keyword == "fo") {  // fo: the same, long ago
      if (!run_is_current_) start_run();
      faces_.add(line, rest);
    } else if (keyword == "vn") {
      vectors_.add_normal(line, rest);
    } else if (keyword == "vt") {
      vectors_.add_uv(line, rest);
    } else if (!keyword.empty() && keyword[0] != '#') {
      read_statement(line, keyword, rest);
    }
  }

  void read_statement(std::string_view line, std::string_view keyword, std::string_view rest) {
    if (keyword == "usemtl") {
      use_material(trimmed(rest));
    } else if (keyword == "g") {
      group_ = joined_words(rest);
      group_line_ = line_number(keyword);
    } else if (keyword == "o") {
      object_ = trimmed(rest);
      object_line_ = line_number(keyword);
      group_.clear();
      group_line_ = 0;
    } else if (keyword == "s") {
      set_smoothing(keyword, rest);
    } else if (keyword == "mtllib") {
      add_library(line, rest);
    } else {
      note_unused(keyword);
    }
    run_is_current_ = false;
  }

  int line_number(std::string_view keyword) const {
    return static_cast<int>(std::min<std::uint64_t>(lines_.place(keyword).line, INT_MAX));
  }

  // Without a name: none from here on.
  void use_material(std::string_view name) {
    const auto next = static_cast<int>(data_.materials.size());
    material_ = -1;
    if (name.empty()) return;
    const auto [entry, is_new] = materials_.emplace(name, next);
    if (is_new) data_.materials.push_back(entry->first);
    material_ = entry->second;
  }

  void set_smoothing(std::string_view keyword, std::string_view rest) {
    const std::string_view word = take_word(rest);
    int number = word == "on" ? 1 : smooth_never;
    if (word != "on" && word != "off") {
      const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      const bool whole = error == std::errc() && stop == word.data() + word.size() && number >= 0;
      if (!whole) return note_unused(keyword);
    }
    smoothing_ = number;
  }

  void add_library(std::string_view line, std::string_view rest) {
    const std::string_view names = trimmed(rest);
    if (names.empty()) lines_.fail(line, "mtllib without a file name");
    if (!library_names_.emplace(names).second) return;
    if (data_.libraries.size() >= most_libraries) {
      lines_.fail(line, fmt::format("more than {} mtllib statements, the limit", most_libraries));
    }
    data_.libraries.push_back({std::string(names), lines_.position(lines_.place(names))});
  }

  void note_unused(std::string_view keyword) {
    const auto known = unused_.find(keyword);
    if (known != unused_.end()) {
      ++known->second.lines;
      return;
    }
    const bool full = unused_.size() >= most_keywords;
    Unused& unused = unused_[full ? std::string() : std::string(keyword)];
    if (unused.lines++ == 0) unused.place = lines_.place(keyword);
  }

  void warn_of_unused(Warnings& warnings) const {
    for (const auto& [keyword, unused] : unused_) {
      const std::string what = keyword.empty() ? "other" : quote(keyword);
      warnings.push_back(fmt::format("{}: {} {} lines: {}", lines_.position(unused.place),
                                     unused.lines, what, why_unused(keyword)));
    }
  }

  void start_run() {
    run_is_current_ = true;
    const ObjRun run{static_cast<std::uint32_t>(data_.triangles.size()), current_group(), material_,
                     smoothing_};
    const ObjRun* last = data_.runs.empty() ? nullptr : &data_.runs.back();
    const bool is_same = last && last->group == run.group && last->material == run.material &&
                         last->smoothing == run.smoothing;
    if (!is_same) data_.runs.push_back(run);
  }

  int current_group() {
    const auto next = static_cast<int>(data_.groups.size());
    const auto [entry, is_new] = groups_.try_emplace(std::pair(object_, group_), next);
    if (is_new) {
      const auto object = objects_.try_emplace(object_, data_.objects);
      data_.objects += object.second ? 1 : 0;
      data_.groups.push_back({object_, group_, object.first->second, object_line_, group_line_});
    }
    return entry->second;
  }

  // Where a file uses smoothing groups, what comes before the first is in none, as `s off`.
  void finish_smoothing() {
    std::vector<ObjRun>& runs = data_.runs;
    const auto is_by_crease = [](const ObjRun& run) { return run.smoothing == smooth_by_crease; };
    if (std::all_of(runs.begin(), runs.end(), is_by_crease)) return;
    for (ObjRun& run : runs) run.smoothing = std::max(run.smoothing, smooth_never);
  }

  LineReader lines_;
  ObjData data_;
  ObjVectors vectors_;
  ObjFaces faces_;
  std::string object_, group_;
  int object_line_ = 0, group_line_ = 0;
  int material_ = -1, smoothing_ = smooth_by_crease;
  bool run_is_current_ = false;
  std::map<std::string, int, std::less<>> materials_;
  std::map<std::string, int> objects_;
  std::map<std::pair<std::string, std::string>, int> groups_;
  std::set<std::string, std::less<>> library_names_;
  std::map<std::string, Unused, std::less<>> unused_;
};

}  // namespace

ObjData parse_obj(const Path& path, const ImportLimits& limits, Warnings& warnings) {
  return ObjParser(path, limits).run(warnings);
}

}  // namespace restframe

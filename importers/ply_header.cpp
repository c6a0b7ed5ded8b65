#include "importers/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

#include "importers/text_lines.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names = {{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

class HeaderReader {
 public:
  HeaderReader(ByteReader& file, const Path& path, Warnings& warnings)
      : file_(file), path_(path), warnings_(warnings) {}

  PlyHeader read() {
    check_magic();
    while (next_line()) {
      std::string_view rest = line_;
      const std::string_view keyword = take_word(rest);
      if (keyword == "end_header") return finished();
      read_line(keyword, rest);
    }
    throw InputError(path_.string() + ": the file ends early: \"end_header\" is missing");
  }

 private:
  void check_magic() {
    const std::string_view head = file_.peek(4);
    const bool is_ply = head.substr(0, 3) == "ply";
    if (!is_ply || head.size() < 4 || (head[3] != '\n' && head[3] != '\r' && head[3] != ' ')) {
      throw InputError(path_.string() + ":1:1: no PLY file: the first line must be \"ply\"");
    }
    find_line_end();
    next_line();
  }

  // All lines end as the first one does: in binary files, a byte that follows may look like the end
  // of a line.
  void find_line_end() {
    const std::string_view head = file_.peek(longest_line);
    const std::size_t end = head.find_first_of("\r\n");
    if (end == head.npos) return;
    line_end_ = head[end] == '\n' ? "\n" : head.substr(end + 1, 1) == "\n" ? "\r\n" : "\r";
  }

  bool next_line() {
    const std::string_view head = file_.peek(longest_line);
    const std::size_t end = head.find(line_end_);
    if (end == head.npos) {
      if (head.size() == longest_line) {
        file_.fail(fmt::format("a line of the header has more than {} bytes", longest_line));
      }
      return false;
    }
    line_ = head.substr(0, end);
    if (line_end_ == "\n" && !line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    file_.skip(end + line_end_.size());
    ++line_number_;
    return true;
  }

  [[noreturn]] void fail(std::string_view word, const std::string& reason) const {
    throw InputError(fmt::format("{}:{}:{}: {}", path_.string(), line_number_,
                                 word.data() - line_.data() + 1, reason));
  }

  void read_line(std::string_view keyword, std::string_view rest) {
    if (keyword == "comment" || keyword == "obj_info") {
      if (take_word(rest) == "TextureFile") header_.textures.emplace_back(trimmed(rest));
    } else if (keyword == "format") {
      read_format(take_word(rest));
    } else if (keyword == "element") {
      read_element(rest);
    } else if (keyword == "property") {
      read_property(rest);
    } else if (!keyword.empty() && header_.elements.empty()) {
      warnings_.push_back(fmt::format("{}:{}:1: {} is no statement of a PLY header, not used",
                                      path_.string(), line_number_, quote(keyword)));
    } else if (!keyword.empty()) {
      fail(keyword, fmt::format("{}, must be \"property\", \"element\", \"comment\" or "
                                "\"end_header\"",
                                quote(keyword)));
    }
  }

  void read_format(std::string_view word) {
    has_format_ = true;
    if (word == "ascii") {
      header_.format = PlyFormat::text;
    } else if (word == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (word == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      fail(word.empty() ? line_ : word,
           fmt::format("format {}, must be ascii, binary_little_endian or binary_big_endian",
                       quote(word)));
    }
  }

  void read_element(std::string_view rest) {
    const std::string_view name = take_word(rest), count = take_word(rest);
    PlyElement element;
    element.name = name;
    const char* end = count.data() + count.size();
    const auto [stop, error] = std::from_chars(count.data(), end, element.count);
    if (count.empty() || stop != end || error == std::errc::invalid_argument) {
      fail(count.empty() ? line_ : count, fmt::format("{} is no number of rows", quote(count)));
    }
    if (error == std::errc::result_out_of_range) element.count = UINT64_MAX;
    for (const PlyElement& other : header_.elements) {
      if (other.name == name) fail(name, fmt::format("a second element {}", quote(name)));
    }
    if (header_.elements.size() >= most_names) fail(name, "more than 1000 elements, the limit");
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::string_view rest) {
    if (header_.elements.empty()) fail(line_, "a property before any element");
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    PlyProperty property;
    std::string_view type = take_word(rest);
    if (type == "list") {
      property.count_type = read_type(take_word(rest));
      type = take_word(rest);
    }
    property.type = read_type(type);
    const std::string_view name = take_word(rest);
    if (name.empty()) fail(line_, "a property without a name");
    property.name = name;
    for (const PlyProperty& other : properties) {
      if (other.name == name) fail(name, fmt::format("a second property {}", quote(name)));
    }
    if (properties.size() >= most_names) fail(name, "more than 1000 properties, the limit");
    properties.push_back(std::move(property));
  }

  PlyType read_type(std::string_view word) const {
    for (const auto& [name, type] : type_names) {
      if (word == name) return type;
    }
    fail(word.empty() ? line_ : word,
         fmt::format("type {}, must be char, uchar, short, ushort, int, uint, float or double",
                     quote(word)));
  }

  PlyHeader finished() {
    if (!has_format_) fail(line_, "no format line before the end of the header");
    header_.bytes = file_.offset();
    return std::move(header_);
  }

  static constexpr std::size_t longest_line = 8192, most_names = 1000;

  ByteReader& file_;
  const Path& path_;
  Warnings& warnings_;
  PlyHeader header_;
  std::string_view line_;
  std::string_view line_end_ = "\n";
  std::size_t line_number_ = 0;
  bool has_format_ = false;
};

// The bytes that a row takes at least: lists may be empty.
std::uint64_t least_size(const PlyElement& element, PlyFormat format) {
  std::uint64_t size = 0;
  for (const PlyProperty& property : element.properties) {
    constexpr std::uint64_t word_size = 2;  // a digit and what divides it from the next
    size += format == PlyFormat::text ? word_size
                                      : size_of(property.count_type.value_or(property.type));
  }
  return size;
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(ByteReader& file, const Path& path, Warnings& warnings) {
  return HeaderReader(file, path, warnings).read();
}

void check_ply_size(const PlyHeader& header, std::size_t left, const Path& path) {
  std::uint64_t room = left + (header.format == PlyFormat::text ? 1 : 0);  // for the last line end
  for (const PlyElement& element : header.elements) {
    const std::uint64_t each = least_size(element, header.format);
    if (each == 0) continue;
    if (element.count > room / each) {
      throw InputError(fmt::format(
          "{}: element {} of {} rows needs at least {} bytes a row, the file has {} left "
          "(truncated?)",
          path.string(), quote(element.name), element.count, each, room));
    }
    room -= element.count * each;
  }
}

}  // namespace restframe

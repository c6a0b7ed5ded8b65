#include "importers/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "scene/error.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <toml++/toml.h>
#pragma GCC diagnostic pop

namespace restframe {
namespace {

constexpr int deepest_key = 32;

TextPosition position_of(const toml::source_region& source, int place) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column), place};
}

ConfigTable config_table(const toml::table& table, int place);

ConfigValue config_value(const toml::node& node, int place) {
  ConfigValue value{position_of(node.source(), place), false};
  if (const auto* table = node.as_table()) {
    value.data = config_table(*table, place);
  } else if (const auto* array = node.as_array()) {
    ConfigArray elements;
    for (const toml::node& element : *array) elements.push_back(config_value(element, place));
    value.data = std::move(elements);
  } else if (const auto* text = node.as_string()) {
    value.data = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.data = boolean->get();
  } else {
    value.data = ConfigDate{};
  }
  return value;
}

ConfigTable config_table(const toml::table& table, int place) {
  ConfigTable result{position_of(table.source(), place), {}};
  for (const auto& [key, node] : table) {
    result.entries.push_back(
        {std::string(key.str()), position_of(key.source(), place), config_value(node, place)});
  }
  // toml++ sorts by name; faults read better in the file's order.
  std::stable_sort(result.entries.begin(), result.entries.end(),
                   [](const ConfigEntry& a, const ConfigEntry& b) {
                     return std::pair(a.key_at.line, a.key_at.column) <
                            std::pair(b.key_at.line, b.key_at.column);
                   });
  return result;
}

// The end of the quoted text that begins at `begin`, past its closing quotes: three quotes run over
// lines, one ends at the line's end at the latest.
std::size_t end_of_quotes(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool multi_line = text.substr(begin, 3) == three;
  std::size_t i = begin + (multi_line ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (multi_line && text.substr(i, 3) == three) {
      return i + 3;
    } else if (!multi_line && (text[i] == quote || text[i] == '\n')) {
      return i + 1;
    }
  }
  return text.size();
}

// toml++ makes a table of every part of a dotted key and destroys them recursively: a long enough
// key would overflow the stack.
void check_key_depth(std::string_view text, const std::string& file) {
  int line = 1, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = end_of_quotes(text, i);
      line += static_cast<int>(std::count(text.begin() + i, text.begin() + end, '\n'));
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '\n') ++line;
    if (c == '.' && ++dots > deepest_key) {
      throw InputError(
          fmt::format("{}:{}:1: a dotted key is deeper than {}", file, line, deepest_key));
    }
    if (std::string_view("\n=,{}[]").find(c) != std::string_view::npos) dots = 0;
    ++i;
  }
}

}  // namespace

ConfigTable parse_toml(const std::string& text, const std::string& file, int place) {
  check_key_depth(text, file);
  try {
    return config_table(toml::parse(text, file), place);
  } catch (const toml::parse_error& error) {
    std::string what(error.description());
    std::replace(what.begin(), what.end(), '\n', ' ');
    const TextPosition at = position_of(error.source(), place);
    throw InputError(fmt::format("{}:{}:{}: {}", file, at.line, at.column, what));
  }
}

}  // namespace restframe

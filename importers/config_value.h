#pragma once

// A settings file as a tree of values that know where they stand. Sections of the scene are read
// from this, whatever syntax it was written in.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace restframe {

// Counted from 1.
struct TextPosition {
  int line = 1, column = 1;
};

struct ConfigValue;
struct ConfigEntry;
using ConfigArray = std::vector<ConfigValue>;

// In the file's order.
struct ConfigTable {
  TextPosition at;
  std::vector<ConfigEntry> entries;
};

struct ConfigDate {};

struct ConfigValue {
  TextPosition at;
  std::variant<bool, std::int64_t, double, std::string, ConfigDate, ConfigArray, ConfigTable> data;
};

struct ConfigEntry {
  std::string key;
  TextPosition key_at;
  ConfigValue value;
};

// "a table", "a whole number"; for messages.
const char* kind_name(const ConfigValue& value);

}  // namespace restframe

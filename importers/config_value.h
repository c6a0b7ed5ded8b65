#pragma once

// A settings file as a tree of values that know where they stand. Sections of the scene are read
// from this, whatever syntax it was written in.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace restframe {

// Where a value stands. Lines and columns are counted from 1; what an asset holds has a place there
// instead (a number that the FaultList gives out), and lines only inside a text.
struct TextPosition {
  int line = 1, column = 1;
  int place = 0;  // 0: the settings file itself
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
struct ConfigNull {};  // of JSON

struct ConfigValue {
  TextPosition at;
  std::variant<bool, std::int64_t, double, std::string, ConfigDate, ConfigArray, ConfigTable,
               ConfigNull>
      data;
};

struct ConfigEntry {
  std::string key;
  TextPosition key_at;
  ConfigValue value;
};

// "a table", "a whole number"; for messages.
const char* kind_name(const ConfigValue& value);

}  // namespace restframe

#include "importers/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/message.h"
#include "scene/suggest.h"

namespace restframe {

const ConfigValue* TableReader::find(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  for (const ConfigEntry& entry : table_.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

std::optional<double> TableReader::number(const std::string& key, const Range& range) {
  const ConfigValue* value = find(key);
  return value ? read_number(*value, key, range, report) : std::nullopt;
}

std::optional<int> TableReader::integer(const std::string& key, int low, int high) {
  const auto wide = whole_number(key, low, high);
  return wide ? std::optional(static_cast<int>(*wide)) : std::nullopt;
}

std::optional<std::int64_t> TableReader::whole_number(const std::string& key, std::int64_t low,
                                                      std::int64_t high) {
  const ConfigValue* value = find(key);
  return value ? read_whole_number(*value, key, low, high, report) : std::nullopt;
}

std::optional<bool> TableReader::boolean(const std::string& key) {
  const ConfigValue* value = find(key);
  if (!value) return std::nullopt;
  if (const auto* boolean = std::get_if<bool>(&value->data)) return *boolean;
  report_kind(*value, key, "true or false", report);
  return std::nullopt;
}

std::optional<std::string> TableReader::text(const std::string& key) {
  const ConfigValue* value = find(key);
  return value ? read_text(*value, key, report) : std::nullopt;
}

std::optional<Vec3> TableReader::vector(const std::string& key, const Range& range) {
  const ConfigValue* value = find(key);
  return value ? read_vector(*value, key, range, report) : std::nullopt;
}

const ConfigTable* TableReader::table(const std::string& key) {
  const ConfigValue* value = find(key);
  if (!value) return nullptr;
  if (const auto* table = std::get_if<ConfigTable>(&value->data)) return table;
  report_kind(*value, key, "a table", report);
  return nullptr;
}

std::vector<const ConfigTable*> TableReader::tables(const std::string& key) {
  std::vector<const ConfigTable*> tables;
  const ConfigValue* value = find(key);
  if (!value) return tables;
  const auto* array = std::get_if<ConfigArray>(&value->data);
  if (!array) {
    report_kind(*value, key, fmt::format("an array of tables, [[{}]]", key), report);
    return tables;
  }
  for (const ConfigValue& element : *array) {
    if (const auto* table = std::get_if<ConfigTable>(&element.data)) {
      tables.push_back(table);
    } else {
      report_kind(element, key, "a table", report);
    }
  }
  return tables;
}

std::optional<std::size_t> TableReader::choice(const std::string& key,
                                               const std::vector<std::string>& names) {
  const ConfigValue* value = find(key);
  const std::optional<std::string> chosen = value ? read_text(*value, key, report) : std::nullopt;
  return chosen ? read_choice(value->at, *chosen, key, names, report) : std::nullopt;
}

std::optional<std::string> TableReader::one_of(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) find(key);
  std::optional<std::string> first;
  for (const ConfigEntry& entry : table_.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) == keys.end()) continue;
    if (first) report(entry.key_at, fmt::format("{} and {} exclude each other", *first, entry.key));
    if (!first) first = entry.key;
  }
  return first;
}

TextPosition TableReader::place(const std::string& key) const {
  for (const ConfigEntry& entry : table_.entries) {
    if (entry.key == key) return entry.value.at;
  }
  return table_.at;
}

TextPosition TableReader::key_place(const std::string& key) const {
  for (const ConfigEntry& entry : table_.entries) {
    if (entry.key == key) return entry.key_at;
  }
  return table_.at;
}

void TableReader::finish() {
  for (const ConfigEntry& entry : table_.entries) {
    if (report.faults.is_full()) return;
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    report(entry.key_at,
           fmt::format("unknown key {}, the nearest known one is \"{}\" (known here: {})",
                       quote(entry.key), nearest(entry.key, known_), fmt::join(known_, ", ")));
  }
}

}  // namespace restframe

#include <fmt/format.h>

#include "importers/scene_file.h"

namespace restframe {
namespace {

const ConfigArray* read_array(const ConfigValue& value, std::size_t size, const std::string& form,
                              const Reporter& report) {
  const auto* array = std::get_if<ConfigArray>(&value.data);
  if (array && array->size() == size) return array;
  report(value.at, "must be " + form);
  return nullptr;
}

// The elements of the array under `key`, of which there must be some.
const ConfigArray& read_list(TableReader& table, const std::string& key, const std::string& form) {
  static const ConfigArray none;
  const ConfigValue* value = table.find(key);
  const auto* array = value ? std::get_if<ConfigArray>(&value->data) : nullptr;
  if (array && !array->empty()) return *array;
  table.report(table.place(key), fmt::format("{} must be an array of {}", key, form));
  return none;
}

IntervalFunction read_intervals(TableReader& table, std::optional<double> period,
                                const ValueRule& rule) {
  const std::string form = "[begin, end, value]";
  std::vector<PlacedInterval> placed;
  for (const ConfigValue& element : read_list(table, "intervals", form)) {
    const ConfigArray* three = read_array(element, 3, form, table.report);
    if (!three) continue;
    const auto begin = read_number((*three)[0], "the beginning", {}, table.report);
    const auto end = read_number((*three)[1], "the end", {}, table.report);
    const auto value = read_value((*three)[2], "the value", rule, table.report);
    if (begin && end && value) placed.push_back({element.at, {*begin, *end, *value}});
  }
  return make_intervals(period, std::move(placed), table.report);
}

KeyFunction read_keys(TableReader& table, std::optional<double> period, const ValueRule& rule) {
  const std::string form = "[time, value]";
  KeyFunction function{period, {}};
  for (const ConfigValue& element : read_list(table, "keys", form)) {
    const ConfigArray* two = read_array(element, 2, form, table.report);
    if (!two) continue;
    const auto time = read_number((*two)[0], "the time", {}, table.report);
    const auto value = read_value((*two)[1], "the value", rule, table.report);
    if (time && value) add_key(function, {*time, *value}, element.at, table.report);
  }
  return function;
}

void add_formula(const ConfigValue& value, FormulaFunction& function, const Reporter& report) {
  const auto text = read_text(value, "formula", report);
  if (!text) return;
  const auto fault = formula_fault(*text);
  if (fault) report(value.at, fmt::format("formula \"{}\" can not be used: {}", *text, *fault));
  function.formulas.push_back(*text);
}

FormulaFunction read_formula(TableReader& table, const ValueRule& rule) {
  FormulaFunction function;
  const ConfigValue& value = *table.find("formula");
  const auto* three = std::get_if<ConfigArray>(&value.data);
  if (three && (!rule.is_color || three->size() != 3)) {
    table.report(value.at, rule.is_color ? "must be one formula or three" : "must be one formula");
  } else if (three) {
    for (const ConfigValue& component : *three) add_formula(component, function, table.report);
  } else {
    add_formula(value, function, table.report);
  }
  const ConfigValue *from = table.find("from"), *to = table.find("to");
  const bool mixes = rule.is_color && !three;
  if (mixes && !(from && to)) {
    table.report(value.at, "one formula of a colour needs from and to, the colours that it mixes");
  } else if (!mixes && (from || to)) {
    table.report((from ? from : to)->at, "from and to go with one formula of a colour only");
  } else if (mixes) {
    function.from = read_value(*from, "from", rule, table.report);
    function.to = read_value(*to, "to", rule, table.report);
  }
  return function;
}

// Keys that belong to other kinds of function than `kind`. A file's are its own matter.
void check_companions(TableReader& table, const std::string& kind) {
  if (kind == "file") return;
  if (table.has("period") && kind == "formula") {
    table.report(table.key_place("period"), "period goes with intervals, keys or a .csv file only");
  }
  for (const char* key : {"from", "to"}) {
    if (table.has(key) && kind != "formula") {
      table.report(table.key_place(key),
                   fmt::format("{} goes with a formula or a .csv file only", key));
    }
  }
  for (const char* key : {"column", "columns", "time"}) {
    if (!table.has(key)) continue;
    table.report(table.key_place(key), fmt::format("{} goes with a .csv file only", key));
  }
}

std::optional<TemporalFunction> read_function(TableReader& table, const ValueRule& rule,
                                              SceneFile& file) {
  const auto kind = table.one_of({"intervals", "keys", "formula", "file"});
  const std::optional<double> period = table.number("period", above(0));
  check_companions(table, kind.value_or("formula"));
  if (!kind) {
    table.report(table.place(), "must have intervals, keys, a formula or a file");
    return std::nullopt;
  }
  if (*kind == "intervals") return read_intervals(table, period, rule);
  if (*kind == "keys") return read_keys(table, period, rule);
  if (*kind == "formula") return read_formula(table, rule);
  return read_function_file(table, period, rule, file);
}

}  // namespace

std::optional<Property> read_property(TableReader& table, const std::string& key,
                                      const ValueRule& rule, SceneFile& file) {
  const ConfigValue* value = table.find(key);
  if (!value) return std::nullopt;
  const auto* over_time = std::get_if<ConfigTable>(&value->data);
  if (!over_time) {
    const auto constant = read_value(*value, key, rule, table.report);
    return constant ? std::optional<Property>(*constant) : std::nullopt;
  }
  TableReader reader(*over_time, {file.faults, table.report.name + ": " + key});
  std::optional<TemporalFunction> function = read_function(reader, rule, file);
  reader.finish();
  if (!function) return std::nullopt;
  file.scene.functions.push_back(std::move(*function));
  file.scene.function_places.push_back(
      file.faults.located(reader.place("formula"), reader.report.name));
  return static_cast<FunctionIndex>(file.scene.functions.size()) - 1;
}

}  // namespace restframe

// Functions of time that stand in files of their own.

#include <fmt/format.h>

#include "importers/asset_file.h"
#include "importers/csv_function.h"
#include "importers/input_file.h"
#include "importers/paper_intervals.h"
#include "importers/scene_file.h"
#include "scene/file_names.h"

namespace restframe {
namespace {

// The names of the three columns of a colour.
std::vector<std::string> read_column_names(TableReader& table) {
  const ConfigValue& value = *table.find("columns");
  const auto* array = std::get_if<ConfigArray>(&value.data);
  std::vector<std::string> names;
  if (!array || array->size() != 3) {
    table.report(value.at, "columns must be three names, of the components of a colour");
    return names;
  }
  for (const ConfigValue& element : *array) {
    const auto name = read_text(element, "a column", table.report);
    if (name) names.push_back(*name);
  }
  return names;
}

// The colours that 0 and 1 mean in the one column that makes a colour.
void read_ends(TableReader& table, const ValueRule& rule, CsvRequest& request) {
  const ConfigValue *from = table.find("from"), *to = table.find("to");
  const bool mixes = rule.is_color && table.has("column");
  if (mixes && !(from && to)) {
    table.report(table.place("column"),
                 "one column of a colour needs from and to, the colours that it mixes; or give "
                 "columns, three names");
  } else if (!mixes && (from || to)) {
    table.report((from ? from : to)->at, "from and to go with one column of a colour only");
  } else if (mixes) {
    request.from = read_value(*from, "from", rule, table.report);
    request.to = read_value(*to, "to", rule, table.report);
  }
}

// Nothing, and faults, where the keys are not those of a CSV file.
std::optional<CsvRequest> read_csv_request(TableReader& table, const std::optional<double>& period,
                                           const ValueRule& rule) {
  CsvRequest request;
  request.period = period;
  if (table.has("time")) request.time = table.text("time").value_or("");
  const auto kind = table.one_of({"column", "columns"});
  if (kind == "columns" && !rule.is_color) {
    table.report(table.key_place("columns"), "columns go with a colour only, give one column");
  } else if (kind == "columns") {
    request.columns = read_column_names(table);
  } else if (kind == "column") {
    if (const auto name = table.text("column")) request.columns = {*name};
  } else {
    table.report(table.place("file"), rule.is_color
                                          ? "a .csv file needs columns, three names, or a column "
                                            "with from and to"
                                          : "a .csv file needs a column");
  }
  read_ends(table, rule, request);
  const bool has_ends = request.from.has_value() && request.to.has_value();
  const bool complete = request.columns.size() == (rule.is_color && !has_ends ? 3U : 1U);
  return complete ? std::optional(request) : std::nullopt;
}

void refuse_csv_keys(TableReader& table) {
  for (const char* key : {"period", "from", "to", "column", "columns", "time"}) {
    if (!table.has(key)) continue;
    table.report(table.key_place(key),
                 fmt::format("{} goes with a .csv file only, a file of another name is read in the "
                             "paper's notation",
                             key));
  }
}

std::optional<TemporalFunction> read_named_file(TableReader& table, const std::string& name,
                                                const std::optional<double>& period,
                                                const ValueRule& rule, SceneFile& file) {
  const Path path = named_path(name, table.place("file"), file);
  const bool is_csv = lower_extension(path) == ".csv";
  std::optional<CsvRequest> request;
  if (is_csv) request = read_csv_request(table, period, rule);
  if (!is_csv) refuse_csv_keys(table);
  if (const auto fault = input_file_fault(path)) {
    table.report(table.place("file"), fmt::format("file \"{}\": {}", name, *fault));
    return std::nullopt;
  }
  if (is_csv && !request) return std::nullopt;
  TemporalFunction function;
  if (is_csv) function = read_csv_function(path, *request, rule);
  if (!is_csv) function = read_paper_intervals(path, rule);
  add_source(file.scene, source_name(name, path, file), path);
  return function;
}

}  // namespace

Path named_path(const std::string& name, TextPosition at, const SceneFile& file) {
  if (!file.asset_being_read) return file.path.parent_path() / Path(name);
  const Path folder = folder_of(*file.asset_being_read);
  const std::string what = file.faults.located(at, fmt::format("file \"{}\"", name));
  return find_asset_file(folder, folder, name, what).value_or(folder / name);
}

std::string source_name(const std::string& name, const Path& path, const SceneFile& file) {
  if (!file.asset_being_read) return name;
  const Path folder = std::filesystem::canonical(folder_of(file.path));
  return path.lexically_proximate(folder).generic_string();
}

std::optional<TemporalFunction> read_function_file(TableReader& table,
                                                   const std::optional<double>& period,
                                                   const ValueRule& rule, SceneFile& file) {
  const auto name = table.text("file");
  if (!name) return std::nullopt;
  try {
    return read_named_file(table, *name, period, rule, file);
  } catch (const InputError& error) {
    file.faults.add(table.place("file"), error);
    return std::nullopt;
  }
}

}  // namespace restframe

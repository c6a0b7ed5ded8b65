#include "importers/scene_file_spectrum.h"

#include <fmt/format.h>

#include "importers/csv_table.h"
#include "importers/input_file.h"
#include "importers/material_change.h"
#include "physics/observer.h"
#include "physics/spectrum.h"
#include "scene/message.h"

namespace restframe {
namespace {

using Points = std::vector<SpectrumPoint>;

Range wavelengths() {
  return from_to(shortest_wavelength, longest_wavelength);
}

// Values and powers: what single precision holds, with room for products.
Range amounts() {
  return from_to(0, 1e30);
}

// The elements of an array of arrays of `least` to `most` numbers.
template <class Add>
void for_rows(const ConfigValue& value, const std::string& form, std::size_t least,
              std::size_t most, const Reporter& report, const Add& add) {
  const auto* rows = std::get_if<ConfigArray>(&value.data);
  if (rows == nullptr || rows->empty()) return report(value.at, "must be an array of " + form);
  for (const ConfigValue& row : *rows) {
    const auto* numbers = std::get_if<ConfigArray>(&row.data);
    if (numbers && numbers->size() >= least && numbers->size() <= most) {
      add(row.at, *numbers);
    } else {
      report(row.at, "must be " + form);
    }
  }
}

void add_point(double wavelength, double value, TextPosition at, const Reporter& report,
               Points& points) {
  const auto w = static_cast<float>(wavelength);
  if (!points.empty() && w < points.back().wavelength) {
    report(at, fmt::format("the wavelength is {}, must be at least that of the point before, {}",
                           wavelength, points.back().wavelength));
  }
  points.push_back({w, static_cast<float>(value)});
}

Points read_points(const ConfigValue& value, const Reporter& report) {
  Points points;
  for_rows(value, "[wavelength, value]", 2, 2, report,
           [&](TextPosition at, const ConfigArray& row) {
             const auto wavelength = read_number(row[0], "the wavelength", wavelengths(), report);
             const auto height = read_number(row[1], "the value", amounts(), report);
             if (wavelength && height) add_point(*wavelength, *height, at, report, points);
           });
  return points;
}

std::optional<double> field_number(const CsvField& field, const std::string& what,
                                   const Range& range, const Reporter& report) {
  double x = 0;
  if (read_number(field.text, x)) return read_number({field.at, x}, what, range, report);
  report(field.at, fmt::format("{}: {}", what, number_fault(field.text)));
  return std::nullopt;
}

// The index of the column that the table names under `key`, or `otherwise`.
std::optional<std::size_t> column_of(TableReader& table, const std::string& key,
                                     std::size_t otherwise, const CsvTable& csv,
                                     const Reporter& report) {
  if (const auto name = table.text(key)) return csv.column(*name);
  if (otherwise < csv.names().size()) return otherwise;
  report({1, 1}, fmt::format("there is one column, must be two: wavelengths in nm, and values"));
  return std::nullopt;
}

Points read_csv(const Path& path, TableReader& table) {
  FaultList faults(path.string());
  const Reporter report{faults, ""};
  CsvTable csv(path, faults);
  Points points;
  if (faults.empty()) {
    const auto wavelength = column_of(table, "wavelength", 0, csv, report);
    const auto column = column_of(table, "column", 1, csv, report);
    std::vector<CsvField> fields;
    while (wavelength && column && csv.next_row(fields)) {
      const CsvField& first = fields[*wavelength];
      const auto w = field_number(first, "the wavelength", wavelengths(), report);
      const auto value = field_number(fields[*column], "the value", amounts(), report);
      if (w && value) add_point(*w, *value, first.at, report, points);
    }
  }
  faults.throw_any();
  return points;
}

Points read_spectrum_file(TableReader& table, SceneFile& file) {
  const auto name = table.text("file");
  if (!table.has("file")) table.report(table.place(), "file is missing");
  if (!name) return {};
  Points points;
  try {
    const Path path = named_path(*name, table.place("file"), file);
    if (const auto fault = input_file_fault(path)) {
      table.report(table.place("file"), fmt::format("file \"{}\": {}", *name, *fault));
      return {};
    }
    points = read_csv(path, table);
    add_source(file.scene, source_name(*name, path, file), path);
  } catch (const InputError& error) {
    file.faults.add(table.place("file"), error);
    return {};
  }
  return points;
}

Points read_measured(const ConfigValue& value, const Reporter& report, SceneFile& file) {
  const auto* table = std::get_if<ConfigTable>(&value.data);
  if (table == nullptr) return read_points(value, report);
  TableReader reader(*table, report);
  for (const char* key : {"wavelength", "column"}) reader.find(key);
  Points points = read_spectrum_file(reader, file);
  reader.finish();
  return points;
}

std::vector<EmissionLine> read_lines(const ConfigValue& value, const Reporter& report) {
  std::vector<EmissionLine> lines;
  for_rows(value, "[wavelength, power] or [wavelength, power, width]", 2, 3, report,
           [&](TextPosition, const ConfigArray& row) {
             EmissionLine line;
             const auto wavelength = read_number(row[0], "the wavelength", wavelengths(), report);
             const auto power = read_number(row[1], "the power", amounts(), report);
             if (!wavelength || !power) return;
             const Range widths{1e-6, *wavelength, false, false};
             const auto width = row.size() > 2 ? read_number(row[2], "the width", widths, report)
                                               : static_cast<double>(line.width);
             line.wavelength = static_cast<float>(*wavelength);
             line.power = static_cast<float>(*power);
             line.width = static_cast<float>(width.value_or(1));
             lines.push_back(line);
           });
  if (lines.size() > most_lines) {
    report(value.at,
           fmt::format("there are {} lines, must be at most {}", lines.size(), most_lines));
  }
  return lines;
}

Reporter named(const Reporter& report, const std::string& key) {
  return {report.faults, report.name + ": " + key};
}

}  // namespace

SpectrumChange read_spectrum(TableReader& table, const std::string& prefix, SceneFile& file) {
  const std::string temperature = prefix + "temperature", measured = prefix + "spectrum",
                    lines = prefix + "lines";
  SpectrumChange change;
  table.one_of({temperature, measured});
  change.temperature =
      read_property(table, temperature, {false, from_to(coldest_kelvin, hottest_kelvin)}, file);
  if (const ConfigValue* value = table.find(measured)) {
    const std::size_t faults_before = file.faults.size();
    change.points = read_measured(*value, named(table.report, measured), file);
    const std::vector<std::string> faults = spectrum_faults({}, {*change.points, {}});
    if (file.faults.size() == faults_before && (change.points->empty() || !faults.empty())) {
      table.report(value->at, faults.empty() ? measured + " has no points" : faults.front());
    }
  }
  if (const ConfigValue* value = table.find(lines)) {
    change.lines = read_lines(*value, named(table.report, lines));
  }
  return change;
}

void set(const SpectrumChange& change, TemporalNumber& temperature, EmissionSpectrum& spectrum) {
  set(change.temperature, temperature);
  // In the gaps of a function.
  if (temperature.function != no_function && temperature.value == 0.0F) {
    temperature.value = static_cast<float>(daylight_kelvin);
  }
  if (change.temperature) spectrum.points.clear();
  if (change.points) {
    spectrum.points = *change.points;
    temperature = {0.0F};
  }
  if (change.lines) spectrum.lines = *change.lines;
}

void read_observe(TableReader& render, RenderSettings& settings) {
  const ConfigTable* table = render.table("observe");
  if (table == nullptr) return;
  TableReader reader(*table, named(render.report, "observe"));
  for (const char* key : {"from", "to"}) {
    if (!reader.has(key)) reader.report(table->at, fmt::format("{} is missing", key));
  }
  const auto from = reader.number("from", wavelengths()), to = reader.number("to", wavelengths());
  reader.finish();
  if (!from || !to) return;
  settings.observe = {*from, *to};
  for (const std::string& fault : band_faults(*settings.observe)) reader.report(table->at, fault);
  if (!settings.doppler) {
    render.report(render.key_place("observe"), "observe needs doppler = true");
  }
}

}  // namespace restframe

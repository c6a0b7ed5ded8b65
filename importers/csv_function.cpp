#include "importers/csv_function.h"

#include <fmt/format.h>

#include <algorithm>

#include "importers/csv_table.h"
#include "scene/message.h"

namespace restframe {
namespace {

// The part of the range that single precision holds.
Range narrowed(const Range& range) {
  constexpr double largest = 3.4e38;
  return {std::max(range.low, -largest), std::min(range.high, largest), range.low_open,
          range.high_open};
}

class CsvFunctionReader {
 public:
  CsvFunctionReader(const CsvRequest& request, const ValueRule& rule, const Reporter& reporter)
      : request_(request), rule_(rule), report(reporter) {
    function_.period = request.period;
  }

  KeyFunction read(CsvTable& table);

 private:
  bool find_columns(const CsvTable& table);
  void read_row(const std::vector<CsvField>& fields);
  std::optional<TemporalValue> value(const std::vector<CsvField>& fields);
  std::optional<double> number(const CsvField& field, const std::string& what, const Range& range);

  const CsvRequest& request_;
  const ValueRule& rule_;
  const Reporter& report;
  std::size_t time_ = 0;
  std::vector<std::size_t> columns_;
  KeyFunction function_;
};

bool CsvFunctionReader::find_columns(const CsvTable& table) {
  const auto time = request_.time.empty() ? std::size_t{0} : table.column(request_.time);
  time_ = time.value_or(0);
  for (const std::string& name : request_.columns) {
    if (const auto column = table.column(name)) columns_.push_back(*column);
  }
  return time && columns_.size() == request_.columns.size();
}

std::optional<double> CsvFunctionReader::number(const CsvField& field, const std::string& what,
                                                const Range& range) {
  double x = 0;
  if (field.text.empty()) {
    report(field.at, what + " is missing, the field is empty");
  } else if (!read_number(field.text, x)) {
    report(field.at, fmt::format("{}: {}", what, number_fault(field.text)));
  } else {
    return read_number({field.at, x}, what, range, report);
  }
  return std::nullopt;
}

std::optional<TemporalValue> CsvFunctionReader::value(const std::vector<CsvField>& fields) {
  const Range range = request_.from ? from_to(0, 1) : narrowed(rule_.range);
  TemporalValue result{0};
  bool good = true;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string what = "the value of " + quote(request_.columns[i]);
    const auto x = number(fields[columns_[i]], what, range);
    result[static_cast<int>(i)] = static_cast<float>(x.value_or(0));
    good = good && x;
  }
  if (!good) return std::nullopt;
  if (!request_.from) return columns_.size() == 1 ? TemporalValue(result.x) : result;
  return glm::mix(*request_.from, *request_.to, result.x);
}

void CsvFunctionReader::read_row(const std::vector<CsvField>& fields) {
  const auto time = number(fields[time_], "the time", {});
  const auto held = value(fields);
  if (time && held) add_key(function_, {*time, *held}, fields[time_].at, report);
}

KeyFunction CsvFunctionReader::read(CsvTable& table) {
  if (!report.faults.empty() || !find_columns(table)) return {};
  std::vector<CsvField> fields;
  while (table.next_row(fields)) read_row(fields);
  if (report.faults.empty() && function_.keys.empty()) {
    report({1, 1}, "there is no row after the line of names, must be at least one");
  }
  return std::move(function_);
}

}  // namespace

KeyFunction read_csv_function(const std::filesystem::path& path, const CsvRequest& request,
                              const ValueRule& rule) {
  FaultList faults(path.string());
  const Reporter report{faults, ""};
  CsvTable table(path, faults);
  KeyFunction function = CsvFunctionReader(request, rule, report).read(table);
  faults.throw_any();
  return function;
}

}  // namespace restframe

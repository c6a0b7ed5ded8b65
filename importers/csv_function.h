#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "importers/value_rule.h"

namespace restframe {

// What a property takes from a CSV file.
struct CsvRequest {
  std::string time;                       // the column of times; empty: the first
  std::vector<std::string> columns;       // one; or three, the components of a colour
  std::optional<TemporalValue> from, to;  // of one column: the colours that 0 and 1 mean
  std::optional<double> period;
};

// Straight lines through the rows. Throws InputError with every fault, FILE:LINE:COLUMN.
KeyFunction read_csv_function(const std::filesystem::path& path, const CsvRequest& request,
                              const ValueRule& rule);

}  // namespace restframe

#pragma once

#include <filesystem>

#include "importers/value_rule.h"

namespace restframe {

// Reads the paper's own syntax (section 4.3), a line each:
//     % period 1.0
//     % interval 0 0.5 Yellow
// with a number in the colour's place where `rule` is a number's. Empty lines, and what follows a
// '#' that is not a colour, are left out. Throws InputError with every fault, FILE:LINE:COLUMN.
IntervalFunction read_paper_intervals(const std::filesystem::path& path, const ValueRule& rule);

}  // namespace restframe

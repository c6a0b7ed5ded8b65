#pragma once

#include <string>
#include <vector>

namespace restframe {

// One line each on standard error.
void report_error(const std::string& message);
void report_warning(const std::string& message);

// The first fault, and how many more there are: `restframe check` lists all.
void report_faults(const std::vector<std::string>& faults);

// What was printed is out; throws OutputError if it could not be written.
void close_standard_output();

}  // namespace restframe

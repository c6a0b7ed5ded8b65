#pragma once

#include <string>

namespace restframe {

// What a benchmark is measured against, in the same run: the ratio of their median times.
struct Target {
  const char* name;       // of the ratio, in the table
  const char* numerator;  // benchmark names
  const char* denominator;
  double goal;
  bool at_least;  // else at most
};

// Runs all benchmarks that were registered, a number of times in random order, and prints and writes (if a
// path is given) the table of ratios. Returns whether every benchmark ran.
bool run_and_report(const std::string& csv_path);

}  // namespace restframe

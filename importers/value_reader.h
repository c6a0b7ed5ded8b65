#pragma once

// Typed reading of one value of a settings file. What is wrong goes to the fault list and reads as
// absent.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "importers/config_value.h"
#include "importers/fault_list.h"
#include "physics/vectors.h"

namespace restframe {

// The numbers that a key allows; always finite ones.
struct Range {
  double low = -std::numeric_limits<double>::max(), high = std::numeric_limits<double>::max();
  bool low_open = false, high_open = false;

  bool contains(double x) const;
  std::string text() const;  // "above 0", "from 0 to 1"
};
Range above(double low);
Range at_least(double low);
Range from_to(double low, double high);
Range between(double low, double high);  // both excluded

// Where faults go, with the name of what is being read ("camera") before each.
struct Reporter {
  FaultList& faults;
  std::string name;

  void operator()(TextPosition at, const std::string& what) const;
};

// "WHAT is a table, must be WANTED"
void report_kind(const ConfigValue& value, const std::string& what, const std::string& wanted,
                 const Reporter& report);

// One value; `what` names it in faults.
std::optional<double> read_number(const ConfigValue& value, const std::string& what,
                                  const Range& range, const Reporter& report);
std::optional<std::string> read_text(const ConfigValue& value, const std::string& what,
                                     const Reporter& report);
std::optional<Vec3> read_vector(const ConfigValue& value, const std::string& what,
                                const Range& range, const Reporter& report);

std::optional<std::int64_t> read_whole_number(const ConfigValue& value, const std::string& what,
                                              std::int64_t low, std::int64_t high,
                                              const Reporter& report);

// The index of `chosen` in `names`.
std::optional<std::size_t> read_choice(TextPosition at, const std::string& chosen,
                                       const std::string& what,
                                       const std::vector<std::string>& names,
                                       const Reporter& report);

}  // namespace restframe

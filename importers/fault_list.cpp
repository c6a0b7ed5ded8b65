#include "importers/fault_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "scene/message.h"

namespace restframe {

void FaultList::add(TextPosition at, const std::string& what) {
  if (!is_full()) faults_.push_back({at, located(at, what)});
}

std::string FaultList::located(TextPosition at, const std::string& what) const {
  return on_one_line(fmt::format("{}:{}:{}: {}", file_, at.line, at.column, what));
}

void FaultList::add(TextPosition at, const InputError& error) {
  for (const std::string& fault : error.faults()) {
    if (!is_full()) faults_.push_back({at, on_one_line(fault)});
  }
}

void FaultList::throw_any() const {
  if (faults_.empty()) return;
  std::vector<Fault> sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.at.line, a.at.column) < std::tie(b.at.line, b.at.column);
  });
  std::vector<std::string> lines;
  for (const Fault& fault : sorted) {
    if (lines.empty() || lines.back() != fault.line) lines.push_back(fault.line);
  }
  throw InputError(std::move(lines));
}

}  // namespace restframe

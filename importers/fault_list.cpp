#include "importers/fault_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "scene/message.h"

namespace restframe {

void FaultList::add(TextPosition at, const std::string& what) {
  add_line(at, located(at, what));
}

std::string FaultList::located(TextPosition at, const std::string& what) const {
  return on_one_line(fmt::format("{}:{}:{}: {}", file_, at.line, at.column, what));
}

void FaultList::add(TextPosition at, const InputError& error) {
  for (const std::string& fault : error.faults()) add_line(at, on_one_line(fault));
}

void FaultList::add_line(TextPosition at, std::string line) {
  constexpr std::size_t most = 1000;
  if (faults_.size() < most) faults_.push_back({at, std::move(line)});
  if (faults_.size() >= most) throw_any();
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

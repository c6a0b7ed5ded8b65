#include "importers/fault_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace restframe {
namespace {

// Keys and texts of the file may hold line breaks; a fault is one line.
std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  }
  return text;
}

}  // namespace

void FaultList::add(TextPosition at, const std::string& what) {
  if (is_full()) return;
  faults_.push_back(
      {at, on_one_line(fmt::format("{}:{}:{}: {}", file_, at.line, at.column, what))});
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

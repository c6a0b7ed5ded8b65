#include "importers/fault_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "scene/message.h"

namespace restframe {

namespace {

// A key as a JSON pointer spells it; cut if it is longer than any that means something.
std::string escaped(const std::string& key) {
  constexpr std::size_t longest = 80;
  std::string text;
  for (const char c : key.substr(0, longest)) {
    if (c == '~') text += "~0";
    if (c == '/') text += "~1";
    if (c != '~' && c != '/') text += c;
  }
  if (key.size() > longest) text += "...";
  return text;
}

}  // namespace

int FaultList::add_place(std::string text) {
  places_.push_back({0, std::move(text)});
  return static_cast<int>(places_.size());
}

int FaultList::add_place(int parent, std::string step) {
  places_.push_back({parent, std::move(step)});
  return static_cast<int>(places_.size());
}

std::string FaultList::place_text(int place) const {
  std::string text;
  while (place > 0) {
    const Place& here = places_[static_cast<std::size_t>(place) - 1];
    text.insert(0, here.parent == 0 ? here.step : escaped(here.step).insert(0, 1, '/'));
    place = here.parent;
  }
  return text;
}

void FaultList::add(TextPosition at, const std::string& what) {
  add_line(at, located(at, what));
}

std::string FaultList::located(TextPosition at, const std::string& what) const {
  const std::string where = at.place == 0 ? file_ : place_text(at.place);
  if (at.line == 0) return on_one_line(fmt::format("{}: {}", where, what));
  return on_one_line(fmt::format("{}:{}:{}: {}", where, at.line, at.column, what));
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
    return std::tie(a.at.place, a.at.line, a.at.column) <
           std::tie(b.at.place, b.at.line, b.at.column);
  });
  std::vector<std::string> lines;
  for (const Fault& fault : sorted) {
    if (lines.empty() || lines.back() != fault.line) lines.push_back(fault.line);
  }
  throw InputError(std::move(lines));
}

}  // namespace restframe

#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "scene/message.h"

namespace restframe {

// What an importer leaves out, a line each, whatever texts of the file a warning quotes.
class Warnings {
 public:
  using value_type = std::string;
  using const_iterator = std::vector<std::string>::const_iterator;
  using iterator = const_iterator;

  Warnings() = default;
  Warnings(std::initializer_list<std::string> lines) {
    for (const std::string& line : lines) push_back(line);
  }

  void push_back(std::string line) { lines_.push_back(on_one_line(std::move(line))); }
  void clear() { lines_.clear(); }

  bool empty() const { return lines_.empty(); }
  std::size_t size() const { return lines_.size(); }
  const std::string& operator[](std::size_t i) const { return lines_[i]; }
  const_iterator begin() const { return lines_.begin(); }
  const_iterator end() const { return lines_.end(); }
  const std::string& back() const { return lines_.back(); }

  friend bool operator==(const Warnings& a, const Warnings& b) { return a.lines_ == b.lines_; }

 private:
  std::vector<std::string> lines_;
};

}  // namespace restframe

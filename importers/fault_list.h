#pragma once

#include <string>
#include <vector>

#include "importers/config_value.h"
#include "scene/error.h"

namespace restframe {

// Collects the faults of one file, so that a user sees all at once: the first thousand, since a
// file of megabytes may have nothing else.
class FaultList {
 public:
  explicit FaultList(std::string file) : file_(std::move(file)) {}

  void add(TextPosition at, const std::string& what);

  // Those of another file that is named at `at`; they have positions of their own.
  void add(TextPosition at, const InputError& error);

  // "FILE:LINE:COLUMN: what"
  std::string located(TextPosition at, const std::string& what) const;

  bool empty() const { return faults_.empty(); }

  // Throws InputError with every fault, in the file's order, if there is any.
  void throw_any() const;

 private:
  struct Fault {
    TextPosition at;
    std::string line;
  };
  bool is_full() const { return faults_.size() >= 1000; }

  std::string file_;
  std::vector<Fault> faults_;
};

}  // namespace restframe

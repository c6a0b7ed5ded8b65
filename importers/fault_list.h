#pragma once

#include <string>
#include <vector>

#include "importers/config_value.h"
#include "scene/error.h"

namespace restframe {

// Collects the faults of one file, so that a user sees all at once. A file of megabytes may have
// nothing else, so whoever adds the thousandth gets them thrown.
class FaultList {
 public:
  explicit FaultList(std::string file) : file_(std::move(file)) {}

  // Throws InputError with every fault once there are a thousand.
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
  void add_line(TextPosition at, std::string line);

  std::string file_;
  std::vector<Fault> faults_;
};

}  // namespace restframe

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene/message.h"

namespace restframe {

// The user's input or options are at fault: exit code 2. Each fault is one line,
// "FILE:LINE:COLUMN or FILE:/json/pointer: what, the value, what to do".
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& fault) : InputError(std::vector<std::string>{fault}) {}
  explicit InputError(std::vector<std::string> faults)
      : std::runtime_error(on_one_line(faults.at(0))), faults_(std::move(faults)) {
    for (std::string& fault : faults_) fault = on_one_line(std::move(fault));
  }

  const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

// Output or resources failed: exit code 3.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Told to stop by a signal: exit code 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace restframe

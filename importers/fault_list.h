#pragma once

#include <string>
#include <vector>

#include "importers/config_value.h"
#include "scene/error.h"

namespace restframe {

// Collects the faults of one file and of what it is made of, so that a user sees all at once. A file
// of megabytes may have nothing else, so whoever adds the thousandth gets them thrown.
class FaultList {
 public:
  explicit FaultList(std::string file) : file_(std::move(file)) {}

  // A place outside the file's own text, "car.glb:/nodes/3/extras", for TextPosition::place.
  int add_place(std::string text);
  // What lies in a place: "/nodes/3/extras" and "velocity" make "/nodes/3/extras/velocity".
  int add_place(int parent, std::string step);
  std::size_t places() const { return places_.size(); }
  std::string place_text(int place) const;

  // Throws InputError with every fault once there are a thousand.
  void add(TextPosition at, const std::string& what);

  // Those of another file that is named at `at`; they have positions of their own.
  void add(TextPosition at, const InputError& error);

  // "FILE:LINE:COLUMN: what", or "FILE:/json/pointer: what", or with LINE:COLUMN of a text there.
  std::string located(TextPosition at, const std::string& what) const;

  bool empty() const { return faults_.empty(); }
  std::size_t size() const { return faults_.size(); }
  bool is_full() const { return faults_.size() >= 1000; }

  // Throws InputError with every fault, in the file's order, if there is any.
  void throw_any() const;

 private:
  struct Fault {
    TextPosition at;
    std::string line;
  };
  struct Place {
    int parent;  // 0: none
    std::string step;
  };
  void add_line(TextPosition at, std::string line);

  std::string file_;
  std::vector<Place> places_;  // number 1 is the first
  std::vector<Fault> faults_;
};

}  // namespace restframe

#pragma once

#include <muParser.h>

#include <string>

namespace restframe {

// A formula in t, compiled once; evaluating it neither allocates nor locks. It keeps state, so
// every thread needs its own, and its address must stay: the parser holds pointers into it.
class Formula {
 public:
  // Throws mu::Parser::exception_type, or std::invalid_argument, with the reason if the text is no
  // formula.
  explicit Formula(const std::string& text);
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;

  double operator()(double time) {
    t_ = time;
    return parser_.Eval();
  }

 private:
  mu::Parser parser_;
  double t_ = 0;
};

}  // namespace restframe

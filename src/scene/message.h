#pragma once

#include <sstream>
#include <string>

namespace restframe {

// The parts one after another, numbers in short form.
template <class... Parts>
std::string message(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

}  // namespace restframe

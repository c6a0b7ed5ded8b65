#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "scene/camera.h"

namespace restframe {

// The canonical text as it grows: a line a key, numbers with all their digits.
class Listing {
 public:
  void add(const std::string& key, double value) { line(key, fmt::format("{:.17g}", value)); }
  void add(const std::string& key, const std::string& value) { line(key, value); }
  void add(const std::string& key, const Vec3& v) {
    line(key, fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z));
  }
  std::string text() && { return std::move(text_); }

 private:
  void line(const std::string& key, const std::string& value) {
    fmt::format_to(std::back_inserter(text_), "{} = {}\n", key, value);
  }
  std::string text_;
};

void add_worldline(Listing& list, const std::string& key, const Worldline& worldline);
void add_camera(Listing& list, const Camera& camera);

}  // namespace restframe

#include "scene/sky_map.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace restframe {
namespace {

constexpr double pi = glm::pi<double>();

const Vec3f& pixel(const SkyMap& map, int column, int row) {
  const int x = column < 0 ? column + map.width : column >= map.width ? column - map.width : column;
  const int y = std::clamp(row, 0, map.height - 1);
  return map.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                    static_cast<std::size_t>(x)];
}

}  // namespace

SkyPlace sky_place(const SkyMap& map, const Vec3& direction) {
  const double longitude = std::atan2(direction.z, direction.x);  // -pi to pi, 0 in the middle
  const double from_zenith = std::atan2(std::hypot(direction.x, direction.z), direction.y);
  return {map.width * (0.5 + longitude / (2 * pi)), map.height * from_zenith / pi};
}

Vec3 sky_direction(const SkyMap& map, const SkyPlace& place) {
  const double longitude = 2 * pi * (place.x / map.width - 0.5);
  const double from_zenith = pi * place.y / map.height;
  const double sine = std::sin(from_zenith);
  return {sine * std::cos(longitude), std::cos(from_zenith), sine * std::sin(longitude)};
}

SkyCorners corners(const SkyMap& map, const SkyCell& cell) {
  return {pixel(map, cell.column, cell.row), pixel(map, cell.column + 1, cell.row),
          pixel(map, cell.column, cell.row + 1), pixel(map, cell.column + 1, cell.row + 1)};
}

Vec3f radiance_at(const SkyMap& map, const SkyPlace& place) {
  // Pixel centres are at half-integers.
  const double left = std::floor(place.x - 0.5), top = std::floor(place.y - 0.5);
  const auto s = static_cast<float>(place.x - 0.5 - left);
  const auto t = static_cast<float>(place.y - 0.5 - top);
  const SkyCell cell{std::clamp(static_cast<int>(left), -1, map.width - 1),
                     std::clamp(static_cast<int>(top), -1, map.height - 1)};
  const SkyCorners c = corners(map, cell);
  return glm::mix(glm::mix(c.upper_left, c.upper_right, s),
                  glm::mix(c.lower_left, c.lower_right, s), t);
}

}  // namespace restframe

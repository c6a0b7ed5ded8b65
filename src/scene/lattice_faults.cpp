#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "scene/lattice_layout.h"

namespace restframe {
namespace {

constexpr std::uint64_t most_parts = 10'000'000, most_flat_triangles = 50'000'000;
constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > largest / b ? largest : a * b;
}

std::uint64_t plus(std::uint64_t a, std::uint64_t b) {
  return a > largest - b ? largest : a + b;
}

std::uint64_t count_of(const Cell& cells) {
  const auto count = [](int n) { return static_cast<std::uint64_t>(std::max(n, 0)); };
  return times(times(count(cells.x), count(cells.y)), count(cells.z));
}

std::uint64_t rods_of(const LatticeSettings& settings) {
  std::uint64_t rods = 0;
  for (int axis = 0; axis < 3; ++axis) rods = plus(rods, count_of(rod_cells(settings, axis)));
  return rods;
}

using Faults = std::vector<std::string>;

void check_count(Faults& faults, const char* what, int value, int least, int most) {
  if (value < least || value > most) {
    faults.push_back(fmt::format("{} {} must be from {} to {}", what, value, least, most));
  }
}

// Not a NaN either. Beyond these bounds single precision has no digits to spare for products.
void check_length(Faults& faults, const char* what, double value) {
  if (!(value >= 1e-15 && value <= 1e15)) {
    faults.push_back(fmt::format("{} {} must be from 1e-15 to 1e15", what, value));
  }
}

void check_sizes(Faults& faults, const LatticeSettings& settings, bool flat) {
  if (const auto parts = lattice_parts(settings); parts > most_parts) {
    faults.push_back(
        fmt::format("{} balls and rods are too many, at most {} may be", parts, most_parts));
  }
  const auto triangles = lattice_triangles(settings);
  if (flat && triangles > most_flat_triangles) {
    faults.push_back(
        fmt::format("{} triangles are too many for one mesh, at most {} may be: share the balls as "
                    "instances, or lower cells or fineness",
                    triangles, most_flat_triangles));
  }
}

// The lattice must be small enough for the digits of single precision.
void check_reach(Faults& faults, const LatticeSettings& settings) {
  const int cells = std::max({settings.cells_x, settings.cells_y, settings.cells_z});
  const double reach = 0.5 * settings.pitch * (cells - 1) + settings.ball_radius;
  const double most = std::min({1e5 * settings.ball_radius, 1e6 * settings.rod_radius, 1e15});
  if (reach > most) {
    faults.push_back(fmt::format(
        "the lattice reaches {} from its centre, but at most {} with ball {} and rod {}: single "
        "precision has too few digits for more",
        reach, most, settings.ball_radius, settings.rod_radius));
  }
}

void check_proportions(Faults& faults, const LatticeSettings& settings) {
  const double ball = settings.ball_radius, rod = settings.rod_radius;
  if (2 * ball > settings.pitch) {
    faults.push_back(
        fmt::format("balls of radius {} overlap at pitch {}, which must be at least {}", ball,
                    settings.pitch, 2 * ball));
  }
  if (rod > ball) {
    faults.push_back(fmt::format("rod {} is thicker than ball {}", rod, ball));
  } else if (rod > 0.79 * ball && rod_inset(make_ball({ball, settings.fineness}), ball, rod) < 0) {
    // An icosahedron's faces are 0.795 of its radius from the centre, those of finer balls farther.
    faults.push_back(
        fmt::format("rod {} would show through the flat faces of ball {} at fineness {}: make it "
                    "thinner or the "
                    "ball finer",
                    rod, ball, settings.fineness));
  }
}

}  // namespace

std::uint64_t lattice_parts(const LatticeSettings& settings) {
  return plus(count_of(cells_of(settings)), rods_of(settings));
}

std::uint64_t ball_triangles(int fineness) {
  return 20ULL << (2 * std::clamp(fineness, 0, 29));
}

std::uint64_t lattice_triangles(const LatticeSettings& settings) {
  const auto rod = 2 * static_cast<std::uint64_t>(std::max(settings.rod_sides, 0));
  return plus(times(count_of(cells_of(settings)), ball_triangles(settings.fineness)),
              times(rods_of(settings), rod));
}

std::vector<std::string> lattice_faults(const LatticeSettings& settings, bool flat) {
  Faults faults;
  const int most_cells = static_cast<int>(most_parts);
  check_count(faults, "cells along x", settings.cells_x, 1, most_cells);
  check_count(faults, "cells along y", settings.cells_y, 1, most_cells);
  check_count(faults, "cells along z", settings.cells_z, 1, most_cells);
  check_count(faults, "fineness", settings.fineness, 0, 7);
  check_count(faults, "rod sides", settings.rod_sides, 3, 1000);
  check_length(faults, "pitch", settings.pitch);
  check_length(faults, "ball", settings.ball_radius);
  check_length(faults, "rod", settings.rod_radius);
  if (faults.empty()) {
    check_sizes(faults, settings, flat);
    check_reach(faults, settings);
    check_proportions(faults, settings);
  }
  return faults;
}

}  // namespace restframe

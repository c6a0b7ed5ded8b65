#pragma once

// Where the balls and rods of a lattice are, for its generator and its writers.

#include <algorithm>

#include "scene/generators.h"

namespace restframe {

// A ball's place in the lattice, from 0 along each axis.
using Cell = glm::ivec3;

inline Cell cells_of(const LatticeSettings& settings) {
  return {settings.cells_x, settings.cells_y, settings.cells_z};
}

inline Vec3 ball_center(const LatticeSettings& settings, const Cell& cell) {
  return settings.pitch * (Vec3(cell) - 0.5 * Vec3(cells_of(settings) - 1));
}

// Turns +Z into `axis` (0 to 2 for X to Z). A permutation of the axes, so that matrix and
// quaternion are exact.
inline Mat3 rod_rotation(int axis) {
  const auto unit = [](int i) {
    Vec3 vector(0);
    vector[i % 3] = 1;
    return vector;
  };
  return {unit(axis + 1), unit(axis + 2), unit(axis)};
}

// Calls visit(cell) for every ball.
template <class Visit>
void for_each_cell(const Cell& cells, const Visit& visit) {
  for (int x = 0; x < cells.x; ++x) {
    for (int y = 0; y < cells.y; ++y) {
      for (int z = 0; z < cells.z; ++z) visit(Cell(x, y, z));
    }
  }
}

// The balls from which a rod leads to the next one along `axis`.
inline Cell rod_cells(const LatticeSettings& settings, int axis) {
  Cell cells = cells_of(settings);
  cells[axis] = std::max(cells[axis], 1) - 1;
  return cells;
}

// How far from the centre of a ball its rods begin: as far out as the whole rim stays below the
// ball's flat faces, less a hundredth of the ball's radius. Negative if the rod is too thick for
// that.
double rod_inset(const Mesh& ball, double ball_radius, double rod_radius);

// From its beginning in one ball to its end in the next.
inline double rod_length(const LatticeSettings& settings, double inset) {
  return settings.pitch - 2 * inset;
}

inline Vec3 rod_start(const LatticeSettings& settings, int axis, const Cell& cell, double inset) {
  return ball_center(settings, cell) + inset * rod_rotation(axis)[2];
}

}  // namespace restframe

#pragma once

// Grids of velocities and directions that the physics tests run over.

#include <random>
#include <vector>

#include "physics/velocity.h"

namespace restframe {

// Unit vectors, uniform on the sphere.
inline std::vector<Vec3> random_directions(int count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<Vec3> directions;
  while (directions.size() < static_cast<std::size_t>(count)) {
    const double x = normal(generator), y = normal(generator), z = normal(generator);
    directions.push_back(glm::normalize(Vec3(x, y, z)));
  }
  return directions;
}

// Along the axes, the diagonals, and at random.
inline std::vector<Vec3> direction_grid(int random_count = 12, unsigned seed = 1) {
  std::vector<Vec3> directions = random_directions(random_count, seed);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) directions.push_back(glm::normalize(Vec3(x, y, z)));
      }
    }
  }
  return directions;
}

// From rest over the slowest double to gamma = 10^6, each in many directions.
inline std::vector<Velocity> velocity_grid(double greatest_gamma = 1e6, int random_count = 4) {
  std::vector<Velocity> velocities = {Velocity()};
  for (const Vec3& direction : direction_grid(random_count, 2)) {
    for (double beta : {1e-300, 1e-150, 1e-12, 1e-6, 0.01, 0.3, 0.6, 0.9, 0.99}) {
      velocities.push_back(Velocity::from_beta(beta * direction));
    }
    for (double gamma : {1 + 1e-12, 10.0, 1000.0, 1e6}) {
      if (gamma <= greatest_gamma) velocities.push_back(Velocity::from_gamma(gamma, direction));
    }
  }
  return velocities;
}

}  // namespace restframe

#pragma once

// Generated assets: balls and lattices of balls joined by rods, as in the paper's section 5.2.2.

#include <cstdint>
#include <string>
#include <vector>

#include "scene/asset.h"

namespace restframe {

struct BallSettings {
  double radius = 1;
  int fineness = 3;  // times an icosahedron is subdivided: 20 * 4^fineness triangles
};

enum class InstanceMode : std::uint8_t {
  nodes,  // one node a part, sharing two meshes
  gpu,    // EXT_mesh_gpu_instancing
  none,   // one flat mesh
};

struct LatticeSettings {
  int cells_x = 7, cells_y = 7, cells_z = 20;  // balls along each axis
  double pitch = 1;                            // distance of neighbouring balls
  double ball_radius = 0.15, rod_radius = 0.05;
  int fineness = 3;    // of the balls
  int rod_sides = 16;  // 2 triangles each
};

// Named "ball": a unit-length smooth normal a vertex, vertices on the sphere. One material slot.
// Throws InputError with ball_faults(), if there are any.
Mesh make_ball(const BallSettings& settings);

// A ball as an asset of its own, of one light grey material "ball".
Asset make_sphere_asset(const BallSettings& settings);

// Every reason why the settings make no ball ("radius 0 is not positive"), without a position.
std::vector<std::string> ball_faults(const BallSettings& settings);

// 20 * 4^fineness
std::uint64_t ball_triangles(int fineness);

// Named "rod": an open tube along +Z from z = 0 to `length`, without caps.
Mesh make_rod(double radius, double length, int sides);

// Centred on the origin. Materials (slots): 0 "balls", 1 "rods". Rods end inside the balls, just
// below their surface, so that neither crack nor inner face shows. `flat` joins everything into one
// mesh; else parts share the meshes "ball" and "rod", the latter turned. Throws InputError with
// lattice_faults(), if there are any.
Asset make_lattice(const LatticeSettings& settings, bool flat);

// Every reason why the settings make no lattice ("rod 0.2 is thicker than ball 0.15"), without a
// position. A flat one is limited by its triangles, another one by its parts.
std::vector<std::string> lattice_faults(const LatticeSettings& settings, bool flat = false);

// Counts, for limits and estimates, without making anything: balls and rods, and the triangles of
// all of them. Numbers too large for the type are given as its largest.
std::uint64_t lattice_parts(const LatticeSettings& settings);
std::uint64_t lattice_triangles(const LatticeSettings& settings);

}  // namespace restframe

#pragma once

// Generated assets: balls and lattices of balls joined by rods, as in the paper's section 5.2.2.

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
  int fineness = 3;     // of the balls
  int rod_sides = 16;   // 2 triangles each
};

// A unit-length smooth normal a vertex; vertices on the sphere. One material slot, "ball".
Mesh make_ball(const BallSettings& settings);

// An open tube along +Z from z = 0 to `length`, without caps.
Mesh make_rod(double radius, double length, int sides);

// Centred on the origin. Materials (slots): 0 "balls", 1 "rods". Rods end inside the balls, just below
// their surface, so that neither crack nor inner face shows. `flat` joins everything into one mesh; else
// parts share one ball and one rod a direction or a rotated one.
Asset make_lattice(const LatticeSettings& settings, bool flat);

// Every reason why the settings make no lattice ("rod 0.2 is thicker than ball 0.15"), without a position.
std::vector<std::string> lattice_faults(const LatticeSettings& settings);

// Counts, for limits and estimates, without making anything.
std::uint64_t lattice_parts(const LatticeSettings& settings);
std::uint64_t lattice_triangles(const LatticeSettings& settings);

}  // namespace restframe

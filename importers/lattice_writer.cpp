#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "importers/glb_writer.h"
#include "importers/importers.h"
#include "importers/obj_writer.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/lattice_layout.h"

namespace restframe {
namespace {

// More make files that other programs hardly open.
constexpr std::uint64_t most_nodes = 100'000;

GlbWriter glb_of(const Asset& asset) {
  GlbWriter glb("lattice");
  for (const Material& material : asset.materials) glb.add_material(material);
  for (const Mesh& mesh : asset.meshes) glb.add_mesh(mesh);
  return glb;
}

void write_nodes(const Asset& asset, const Path& path) {
  GlbWriter glb = glb_of(asset);
  for (const Part& part : asset.parts) {
    glb.add_node(name_of(asset, part), part.mesh, Mat3(part.asset_from_mesh),
                 Vec3(part.asset_from_mesh[3]));
  }
  glb.write(path);
}

// Where the rods along `axis` are, in axes turned as they are.
std::vector<Vec3f> rod_translations(const LatticeSettings& settings, int axis, double inset) {
  const Mat3 rod_from_lattice = glm::transpose(rod_rotation(axis));
  std::vector<Vec3f> translations;
  for_each_cell(rod_cells(settings, axis), [&](const Cell& cell) {
    translations.emplace_back(rod_from_lattice * rod_start(settings, axis, cell, inset));
  });
  return translations;
}

// The layout goes straight into arrays: a part each would take ten times the file's size.
void write_instances(const LatticeSettings& settings, const Path& path) {
  LatticeSettings corner = settings;
  corner.cells_x = std::min(corner.cells_x, 2);
  corner.cells_y = std::min(corner.cells_y, 2);
  corner.cells_z = std::min(corner.cells_z, 2);
  const Asset pieces = make_lattice(corner, false);
  const double inset = rod_inset(pieces.meshes[0], settings.ball_radius, settings.rod_radius);
  GlbWriter glb = glb_of(pieces);
  std::vector<Vec3f> balls;
  for_each_cell(cells_of(settings),
                [&](const Cell& cell) { balls.emplace_back(ball_center(settings, cell)); });
  glb.add_instances("balls", 0, Mat3(1), balls);
  std::array<std::vector<Vec3f>, 3> rods;
  for (int axis = 0; axis < 3; ++axis) {
    rods[axis] = rod_translations(settings, axis, inset);
    const std::string name = fmt::format("rods_{}", "xyz"[axis]);
    if (!rods[axis].empty()) glb.add_instances(name, 1, rod_rotation(axis), rods[axis]);
  }
  glb.write(path);
}

void check_nodes(const LatticeSettings& settings) {
  if (const auto parts = lattice_parts(settings); parts > most_nodes) {
    throw InputError(
        fmt::format("instances nodes: {} balls and rods are too many, at most {} may be: choose "
                    "instances gpu, or "
                    "none for one flat mesh",
                    parts, most_nodes));
  }
}

}  // namespace

void write_lattice(const LatticeSettings& settings, InstanceMode mode, const Path& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".glb" && extension != ".obj") {
    throw InputError(fmt::format("{}: a lattice is written as .glb or .obj, not as \"{}\"",
                                 path.string(), path.extension().string()));
  }
  const bool flat = mode == InstanceMode::none || extension == ".obj";
  if (const auto faults = lattice_faults(settings, flat); !faults.empty()) throw InputError(faults);
  if (!flat && mode == InstanceMode::nodes) check_nodes(settings);
  if (extension == ".obj") {
    write_obj(make_lattice(settings, true), path);
  } else if (mode == InstanceMode::gpu) {
    write_instances(settings, path);
  } else {
    write_nodes(make_lattice(settings, flat), path);
  }
}

}  // namespace restframe

#include "app/options_authoring.h"

#include <fmt/format.h>

#include "app/option_values.h"
#include "scene/error.h"
#include "scene/file_names.h"
#include "scene/message.h"

namespace restframe {

CLI::App* add_lattice(CLI::App& app, LatticeOptions& options, AuthoringTexts& texts) {
  CLI::App* command =
      app.add_subcommand("lattice", "Author a lattice of balls and rods (.glb, .obj)");
  LatticeSettings& lattice = options.lattice;
  command->add_option("-o,--output", options.output, "The file to write: .glb or .obj")->required();
  command->add_option("--cells", texts.cells, "Balls along x, y and z")->default_str("7x7x20");
  command->add_option("--pitch", lattice.pitch, "Distance of neighbouring balls")
      ->capture_default_str();
  command->add_option("--ball", lattice.ball_radius, "Radius of the balls")->capture_default_str();
  command->add_option("--rod", lattice.rod_radius, "Radius of the rods")->capture_default_str();
  command->add_option("--fineness", lattice.fineness, "Times the balls' icosahedron is subdivided")
      ->capture_default_str();
  command
      ->add_option("--instances", texts.instances,
                   "nodes: a node a part; gpu: EXT_mesh_gpu_instancing; none: one flat mesh")
      ->check(CLI::IsMember({"nodes", "gpu", "none"}))
      ->capture_default_str();
  return command;
}

CLI::App* add_curves(CLI::App& app, CurvesOptions& curves, AuthoringTexts& texts) {
  CLI::App* command = app.add_subcommand(
      "curves",
      "Draw how fast a moving clock is seen to run against viewing direction (.svg, .csv)");
  command->add_option("-o,--output", curves.output, "The drawing; the table lies beside, as .csv")
      ->capture_default_str();
  command->add_option("--speeds", texts.speeds, "Up to 8, in fractions of c")
      ->default_str("0.85,0.9,0.99");
  command->add_option("--step", curves.step, "Degrees between the table's rows, 0.001 to 90")
      ->capture_default_str();
  return command;
}

LatticeOptions completed(LatticeOptions options, const AuthoringTexts& texts) {
  LatticeSettings& lattice = options.lattice;
  if (!texts.cells.empty()) {
    parse_sizes("--cells", texts.cells, {&lattice.cells_x, &lattice.cells_y, &lattice.cells_z});
  }
  if (texts.instances == "gpu") options.instances = InstanceMode::gpu;
  if (texts.instances == "none") options.instances = InstanceMode::none;
  return options;
}

CurvesOptions completed(CurvesOptions options, const AuthoringTexts& texts) {
  if (!texts.speeds.empty()) options.speeds = parse_speeds(texts.speeds);
  if (!(options.step >= 0.001 && options.step <= 90)) {
    throw InputError(fmt::format("--step: {} degrees, must be 0.001 to 90", options.step));
  }
  if (lower_extension(options.output) != ".svg") {
    throw InputError(fmt::format("--output: {} must end in .svg", quote(options.output)));
  }
  return options;
}

}  // namespace restframe

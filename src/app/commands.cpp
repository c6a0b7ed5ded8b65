#include "app/commands.h"

#include <fmt/format.h>

#include "app/messages.h"
#include "scene/error.h"

namespace restframe {
int run(const Options& options) {
  struct Dispatch {
    const ImportLimits& limits;
    int operator()(const RenderOptions& o) const { return render(o, limits); }
    int operator()(const LatticeOptions& o) const { return author_lattice(o); }
    int operator()(const InfoOptions& o) const { return info(o, limits); }
    int operator()(const CheckOptions& o) const { return check(o, limits); }
  };
  return std::visit(Dispatch{options.limits}, options.command);
}

int author_lattice(const LatticeOptions& options) {
  const std::vector<std::string> faults = lattice_faults(options.lattice);
  if (!faults.empty()) throw InputError("lattice: " + faults.front());
  write_lattice(options.lattice, options.instances, options.output);
  const bool flat = options.instances == InstanceMode::none || options.output.ends_with(".obj");
  fmt::print("{}: a lattice of {} balls and rods, {} triangles{}\n", options.output,
             lattice_parts(options.lattice), lattice_triangles(options.lattice),
             flat ? ", one mesh" : ", instanced");
  return 0;
}

int check(const CheckOptions& options, const ImportLimits& limits) {
  Warnings warnings;
  std::vector<std::string> faults;
  try {
    const Scene scene = load_scene(options.file, limits, warnings);
    for (const std::string& fault : validate(scene)) faults.push_back(options.file + ": " + fault);
  } catch (const InputError& error) {
    faults = error.faults();
  }
  for (const std::string& warning : warnings) report_warning(warning);
  for (const std::string& fault : faults) report_error(fault);
  if (!faults.empty()) return 2;
  fmt::print("{}: no fault found\n", options.file);
  return 0;
}

}  // namespace restframe

#include "app/commands.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/messages.h"
#include "scene/error.h"

namespace restframe {
int run(const Options& options) {
  struct Dispatch {
    const ImportLimits& limits;
    int operator()(const RenderOptions& o) const { return render(o, limits); }
    int operator()(const MergeOptions& o) const { return merge(o, limits); }
    int operator()(const LatticeOptions& o) const { return author_lattice(o); }
    int operator()(const InfoOptions& o) const { return info(o, limits); }
    int operator()(const CheckOptions& o) const { return check(o, limits); }
    int operator()(const SubmitOptions& o) const { return submit(o, limits); }
    int operator()(const StatusOptions& o) const { return status(o, limits); }
    int operator()(const CurvesOptions& o) const { return curves(o); }
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

void throw_faults(const Scene& scene, const std::string& file) {
  std::vector<std::string> faults = validate(scene);
  for (std::string& fault : faults) fault.insert(0, file + ": ");
  if (!faults.empty()) throw InputError(std::move(faults));
}

namespace {

// The first ones: a file of megabytes may ask for a warning in every line.
void report_warnings(const Warnings& warnings) {
  constexpr std::size_t most = 100;
  for (std::size_t i = 0; i < std::min(warnings.size(), most); ++i) report_warning(warnings[i]);
  if (warnings.size() > most) {
    report_warning(fmt::format("and {} warnings more", warnings.size() - most));
  }
}

}  // namespace

Scene loaded_scene(const std::string& file, const ImportLimits& limits,
                   const std::optional<std::string>& variant) {
  Warnings warnings;
  Scene scene = load_scene(file, limits, warnings, variant);
  report_warnings(warnings);
  throw_faults(scene, file);
  return scene;
}

int check(const CheckOptions& options, const ImportLimits& limits) {
  try {
    loaded_scene(options.file, limits);
  } catch (const InputError& error) {
    for (const std::string& fault : error.faults()) report_error(fault);
    return 2;
  }
  fmt::print("{}: no fault found\n", options.file);
  return 0;
}

}  // namespace restframe

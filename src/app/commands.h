#pragma once

#include "app/options.h"

namespace restframe {

// Each returns the exit code, or throws what main turns into one.
int run(const Options& options);

// A scene or asset that can be rendered; its warnings are on standard error. Throws InputError with every fault.
Scene loaded_scene(const std::string& file, const ImportLimits& limits,
                   const std::optional<std::string>& variant = {});

// Throws InputError with every fault that validate() finds, each with the file's name.
void throw_faults(const Scene& scene, const std::string& file);

int render(const RenderOptions& options, const ImportLimits& limits);
int merge(const MergeOptions& options, const ImportLimits& limits);
int author_lattice(const LatticeOptions& options);
int info(const InfoOptions& options, const ImportLimits& limits);
int check(const CheckOptions& options, const ImportLimits& limits);
int submit(const SubmitOptions& options, const ImportLimits& limits);
int status(const StatusOptions& options, const ImportLimits& limits);
int curves(const CurvesOptions& options);

}  // namespace restframe

#pragma once

#include "app/options.h"

namespace restframe {

// Each returns the exit code, or throws what main turns into one.
int run(const Options& options);

int render(const RenderOptions& options, const ImportLimits& limits);
int author_lattice(const LatticeOptions& options);
int info(const InfoOptions& options, const ImportLimits& limits);
int check(const CheckOptions& options, const ImportLimits& limits);

}  // namespace restframe

#pragma once

// The options of the commands that make something without a scene.

#include <CLI/CLI.hpp>
#include <string>

#include "app/options.h"

namespace restframe {

// As given, still to be read.
struct AuthoringTexts {
  std::string cells, instances = "nodes", speeds;
};

CLI::App* add_lattice(CLI::App& app, LatticeOptions& options, AuthoringTexts& texts);
CLI::App* add_curves(CLI::App& app, CurvesOptions& curves, AuthoringTexts& texts);

// With what the texts say. Throws InputError.
LatticeOptions completed(LatticeOptions options, const AuthoringTexts& texts);
CurvesOptions completed(CurvesOptions options, const AuthoringTexts& texts);

}  // namespace restframe

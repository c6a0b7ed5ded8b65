#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "importers/importers.h"
#include "scene/generators.h"
#include "scene/settings.h"

namespace restframe {

struct PictureRange {
  int first = 0, last = 0;  // inclusive
};

struct RenderOptions {
  std::string scene;
  std::optional<std::string> output;
  std::optional<std::string> variant;  // of an asset that is rendered without a scene file
  std::optional<PictureRange> pictures;
  std::optional<int> width, height, samples;
  std::optional<double> noise;
  std::optional<double> exposure;  // of the previews
  std::optional<ViewTransform> view;
  int threads = 0;  // 0: all cores
  bool overwrite = false;
  bool quiet = false;
  std::optional<std::string> video, contact_sheet;  // files made of the previews
};

// Pictures made by a cluster's scheduler.
struct SubmitOptions {
  RenderOptions render;
  bool by_slurm = false;
  std::vector<std::string>
      passed_on;  // options of the scene and its pictures as given, for each task
  int chunk = 0;  // pictures a task; 0: as many as give at most 100 tasks
  std::string time, partition, memory;  // of a task, in Slurm's words; empty: as we or Slurm choose
  std::vector<std::string> directives;  // further options of sbatch
  bool dry_run = false;
};

// Which pictures are there.
struct StatusOptions {
  RenderOptions render;
  bool json = false;
};

struct LatticeOptions {
  std::string output;
  LatticeSettings lattice;
  InstanceMode instances = InstanceMode::nodes;
};

struct InfoOptions {
  std::string file;
  bool json = false;
};

struct CheckOptions {
  std::string file;
};

// The paper's figure 5.
struct CurvesOptions {
  std::string output = "out/curves.svg";           // the CSV lies beside it
  std::vector<double> speeds = {0.85, 0.9, 0.99};  // fractions of c
  double step = 1;                                 // degrees between the CSV's rows
};

struct Options {
  std::variant<RenderOptions, LatticeOptions, InfoOptions, CheckOptions, CurvesOptions,
               SubmitOptions, StatusOptions>
      command;
  ImportLimits limits;
};

// --help or --version was asked for, and is on standard output.
struct HelpShown {
  int exit_code = 0;
};

// Throws InputError with one line, or HelpShown.
Options parse_options(int argc, char** argv);

}  // namespace restframe

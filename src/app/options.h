#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "importers/importers.h"
#include "scene/generators.h"
#include "scene/settings.h"

namespace restframe {

// The pictures first, first + step, ... up to last.
struct PictureRange {
  int first = 0, last = 0, step = 1;
};

// The part-th of so many shares of a picture's tiles; the first is 1.
struct TileShare {
  int part = 1, count = 1;
};
inline constexpr int most_shares = 10'000;
inline bool is_share(const TileShare& share) {
  return share.part >= 1 && share.part <= share.count && share.count <= most_shares;
}

struct RenderOptions {
  std::string scene;
  std::optional<std::string> output;
  std::optional<std::string> variant;  // of an asset that is rendered without a scene file
  std::vector<PictureRange> pictures;  // none: all
  std::optional<TileShare> tile;       // only these tiles, into part files
  double checkpoint = 120;             // seconds between two of a picture; 0: none
  std::optional<int> width, height, samples;
  std::optional<double> noise;
  std::optional<double> exposure;  // of the previews
  std::optional<ViewTransform> view;
  int threads = 0;  // 0: all cores
  bool overwrite = false;
  bool quiet = false;
  std::optional<std::string> video, contact_sheet;  // files made of the previews
};

// The parts of pictures that were rendered with such options, and shares, go together.
struct MergeOptions {
  RenderOptions render;
  bool keep = false;  // the part files
};

// Pictures made by a cluster's scheduler.
struct SubmitOptions {
  RenderOptions render;
  bool by_slurm = false;
  std::vector<std::string> passed_on;   // options of the pictures as given, for each task
  std::vector<std::string> work;        // likewise, of how they are made
  std::string pictures;                 // likewise, for those that are checked in the end
  int chunk = 0;                        // pictures a task; 0: as many as give at most 100 tasks
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
  std::variant<RenderOptions, MergeOptions, LatticeOptions, InfoOptions, CheckOptions,
               CurvesOptions, SubmitOptions, StatusOptions>
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

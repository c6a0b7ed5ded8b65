#pragma once

// What Slurm is given: an array of tasks that render a chunk of pictures each, and a job after them
// that says what is missing.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/job_needs.h"
#include "app/options.h"

namespace restframe {

struct SlurmPlan {
  std::filesystem::path program, scene;  // absolute, as the nodes of the cluster see them, too
  std::string output;                    // the pattern, absolute
  std::filesystem::path folder;          // of scripts, logs and the record
  std::vector<std::string> passed_on;    // further options of the pictures ...
  std::vector<std::string> work;         // ... and of how they are made
  std::string pictures;            // to check afterwards, as `--pictures` takes them; empty: all
  std::vector<std::string> tasks;  // the pictures of each, likewise
  JobNeeds needs;
  std::string memory, time, partition;  // of a task, as Slurm reads them; memory empty: as needed
  std::vector<std::string> directives;  // further options of sbatch
};

// A word that a shell takes as it is, whatever characters are in it.
std::string shell_word(std::string_view word);

// "out/shot.slurm" for "out/shot.####.exr".
std::filesystem::path slurm_folder(const std::string& pattern);
// What the array is called in the queue; the other one has "-check" after it.
std::string slurm_job_name(const std::string& pattern);

std::string render_script(const SlurmPlan& plan);
std::string check_script(const SlurmPlan& plan);

// What sbatch is told: the paths that a script's comments could not hold.
std::vector<std::string> render_arguments(const SlurmPlan& plan);
// After all tasks of the array, whatever became of them.
std::vector<std::string> check_arguments(const SlurmPlan& plan, const std::string& array_id);

}  // namespace restframe

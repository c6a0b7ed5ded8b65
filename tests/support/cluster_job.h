#pragma once

// A small animation, and scripts that stand in for Slurm's commands, in a folder with a name that a
// shell or Slurm could misread.

#include <filesystem>
#include <string>
#include <vector>

#include "support/file_bytes.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {

inline constexpr const char* kClusterScene = R"(
[camera]
position = [0, 0, 4]
[animation]
rate = 10
pictures = 7
[render]
resolution = [16, 12]
samples = 1
[output]
path = "out/p $x.##.exr"
[[object]]
sphere = {radius = 1, fineness = 1}
velocity = [0, 0, 0.5]
)";

// Keeps its arguments; array and check have these numbers.
inline constexpr const char* kRecordingSbatch = R"(#!/bin/sh
printf '%s\n' "$@" >> calls.txt
for script; do :; done
echo 'sbatch: warning: a word of the cluster' >&2
case $script in *check.sh) echo 78 ;; *) echo '77;some_cluster' ;; esac
)";

class ClusterJob {
 public:
  ClusterJob() { write("scene.toml", kClusterScene); }

  std::filesystem::path path(const std::string& name) const {
    return folder_.path() / kName / name;
  }
  void write(const std::string& name, const std::string& text) const {
    folder_.write(std::filesystem::path(kName) / name, text);
  }
  std::string content(const std::string& name) const { return bytes_of(path(name)); }
  void install(const std::string& program, const std::string& script) const {
    write("bin/" + program, script);
    std::filesystem::permissions(path("bin/" + program), std::filesystem::perms::owner_all);
  }
  // restframe, with what is installed and nothing else on the PATH.
  RunResult run(const std::vector<std::string>& arguments) const {
    RunOptions options;
    options.folder = path("");
    options.path_variable = path("bin").string();
    return run_program(RESTFRAME_PROGRAM, arguments, options);
  }
  // As a node of the cluster would run the script.
  RunResult run_task(const std::string& script, int task) const {
    return run_program("/usr/bin/env", {"SLURM_ARRAY_TASK_ID=" + std::to_string(task),
                                        "SLURM_CPUS_PER_TASK=1", "/bin/sh", path(script).string()});
  }

 private:
  static constexpr const char* kName = "a b'c %j \"d\"";
  TemporaryFolder folder_;
};

}  // namespace restframe

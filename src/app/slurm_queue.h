#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace restframe {

// Slurm's number of the job in what `sbatch --parsable` said ("123" or "123;cluster", perhaps after
// warnings).
std::optional<std::string> submitted_id(const std::string& said);

// The arrays that were submitted to make some pictures are kept in a file beside the scripts, so
// that the pictures' status can tell of them. Throws OutputError.
void record_array(const std::filesystem::path& folder, const std::string& id,
                  const std::string& what);
std::vector<std::string> recorded_arrays(const std::filesystem::path& folder);

// Tasks that are not at their end.
struct QueueCounts {
  int running = 0, waiting = 0;
};

// Of these arrays, which have this name, by what squeue says. Throws OutputError with what else it
// said, and Interrupted.
QueueCounts queue_counts(const std::filesystem::path& squeue, const std::string& job_name,
                         const std::vector<std::string>& arrays);

}  // namespace restframe

#include "app/slurm_queue.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/child_process.h"
#include "scene/atomic_file.h"
#include "scene/error.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_arrays = 16;  // that are asked for: older ones have long ended

fs::path record_of(const fs::path& folder) {
  return folder / "arrays.txt";
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

QueueCounts counts_in(const std::string& states) {
  QueueCounts counts;
  std::istringstream words(states);
  for (std::string word; words >> word;) {
    const bool runs = word == "RUNNING" || word == "COMPLETING" || word == "CONFIGURING";
    const bool waits = word == "PENDING" || word == "SUSPENDED" || word.rfind("REQUEUE", 0) == 0;
    counts.running += runs ? 1 : 0;
    counts.waiting += waits ? 1 : 0;
  }
  return counts;
}

}  // namespace

std::optional<std::string> submitted_id(const std::string& said) {
  std::optional<std::string> id;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const std::string first = line.substr(0, line.find(';'));
    if (is_number(first)) id = first;
  }
  return id;
}

void record_array(const fs::path& folder, const std::string& id, const std::string& what) {
  const std::string before = content_of(record_of(folder));
  write_file_atomically(record_of(folder), [&](AtomicFile& file) {
    file.write(before);
    file.write(fmt::format("{} {}\n", id, what));
  });
}

std::vector<std::string> recorded_arrays(const fs::path& folder) {
  std::vector<std::string> ids;
  std::istringstream lines(content_of(record_of(folder)));
  for (std::string line; std::getline(lines, line);) {
    const std::string id = line.substr(0, line.find(' '));
    if (is_number(id)) ids.push_back(id);
  }
  if (ids.size() > most_arrays) ids.erase(ids.begin(), ids.end() - most_arrays);
  return ids;
}

QueueCounts queue_counts(const fs::path& squeue, const std::string& job_name,
                         const std::vector<std::string>& arrays) {
  constexpr std::size_t all_states = 64'000'000;
  const ChildResult result = run_child(
      squeue,
      {"--noheader", "--array", "--format=%T", "--name=" + job_name,
       fmt::format("--jobs={}", fmt::join(arrays, ","))},
      [] { return std::string(); }, all_states);
  // Where it is asked for one array, it takes one that has long ended for a mistake.
  const bool ended = result.last_lines.find("Invalid job id") != std::string::npos;
  if (!result.succeeded && !ended) throw OutputError("squeue failed: " + words_of(result));
  return counts_in(result.last_lines);
}

}  // namespace restframe

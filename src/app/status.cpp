#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/child_process.h"
#include "app/commands.h"
#include "app/number_ranges.h"
#include "app/resume.h"
#include "app/slurm_queue.h"
#include "app/slurm_script.h"
#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

struct PictureStates {
  std::vector<int> finished, missing, torn, of_another_scene;
  std::string difference;  // of the first one of another scene
};

bool is_any_there(const PictureFiles& files) {
  return std::any_of(files.images.begin(), files.images.end(), [](const LayerFile& image) {
    std::error_code error;
    return fs::exists(fs::symlink_status(image.path, error));
  });
}

PictureStates states_of(const Job& job) {
  PictureStates states;
  const std::vector<FoundPicture> pictures = find_pictures(job);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int number = job.numbers[i];
    if (pictures[i].found == Found::finished) {
      states.finished.push_back(number);
    } else if (!pictures[i].difference.empty()) {
      if (states.difference.empty()) states.difference = pictures[i].difference;
      states.of_another_scene.push_back(number);
    } else if (is_any_there(job.files(number))) {
      states.torn.push_back(number);
    } else {
      states.missing.push_back(number);
    }
  }
  return states;
}

// What Slurm does about the pictures; nothing where it was not asked to, or can not be asked.
struct SlurmState {
  QueueCounts counts;
  std::string fault;  // why squeue could not tell
};

std::optional<SlurmState> slurm_state(const std::string& pattern) {
  const std::vector<std::string> arrays = recorded_arrays(slurm_folder(pattern));
  const auto squeue = program_on_path("squeue");
  if (arrays.empty() || !squeue) return std::nullopt;
  try {
    return SlurmState{queue_counts(*squeue, slurm_job_name(pattern), arrays), {}};
  } catch (const OutputError& error) {
    return SlurmState{{}, error.what()};
  }
}

void print_text(const Job& job, const PictureStates& states,
                const std::optional<SlurmState>& slurm) {
  const auto print = [](const std::string& line) { fmt::print("{}\n", on_one_line(line)); };
  print(fmt::format("{}: {} of {} pictures finished", job.scene.output.path, states.finished.size(),
                    job.numbers.size()));
  const auto list = [&](const char* what, const std::vector<int>& numbers) {
    if (!numbers.empty()) print(fmt::format("{}: {}", what, ranges_text(numbers)));
  };
  list("missing", states.missing);
  list("torn", states.torn);
  if (!states.of_another_scene.empty()) {
    print(fmt::format("of another scene: {} ({})", ranges_text(states.of_another_scene),
                      states.difference));
  }
  if (!slurm) return;
  print(slurm->fault.empty() ? fmt::format("slurm: {} running, {} waiting", slurm->counts.running,
                                           slurm->counts.waiting)
                             : "slurm: " + slurm->fault);
}

nlohmann::ordered_json json_of(const std::vector<int>& numbers) {
  auto list = nlohmann::ordered_json::array();
  for (const PictureRange& range : ranges_of(numbers)) list.push_back({range.first, range.last});
  return list;
}

void print_json(const Job& job, const PictureStates& states,
                const std::optional<SlurmState>& slurm) {
  nlohmann::ordered_json document = {{"output", job.scene.output.path},
                                     {"finished", json_of(states.finished)},
                                     {"missing", json_of(states.missing)},
                                     {"torn", json_of(states.torn)},
                                     {"of_another_scene", json_of(states.of_another_scene)}};
  if (!states.difference.empty()) document["difference"] = states.difference;
  if (slurm && slurm->fault.empty()) {
    document["slurm"] = {{"running", slurm->counts.running}, {"waiting", slurm->counts.waiting}};
  }
  fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

int status(const StatusOptions& options, const ImportLimits& limits) {
  const Job job = loaded_job(options.render, limits);
  const PictureStates states = states_of(job);
  const auto slurm = slurm_state(job.scene.output.path);
  if (options.json) {
    print_json(job, states, slurm);
  } else {
    print_text(job, states, slurm);
  }
  const bool all = states.missing.empty() && states.torn.empty() && states.of_another_scene.empty();
  return all ? 0 : 3;
}

}  // namespace restframe

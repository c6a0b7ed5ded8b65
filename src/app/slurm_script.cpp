#include "app/slurm_script.h"

#include <fmt/format.h>

#include <algorithm>

namespace restframe {
namespace {

namespace fs = std::filesystem;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-.").find(c) != std::string_view::npos;
}

// The name of the pictures without their number: "shot" of "out/shot.####.exr".
std::string stem_of(const std::string& pattern) {
  std::string stem = fs::path(pattern).stem().string();
  stem.erase(std::remove(stem.begin(), stem.end(), '#'), stem.end());
  while (!stem.empty() && std::string_view("._- ").find(stem.back()) != std::string_view::npos) {
    stem.pop_back();
  }
  return stem.empty() ? "pictures" : stem;
}

std::string memory_of(const SlurmPlan& plan) {
  if (!plan.memory.empty()) return plan.memory;
  constexpr std::size_t unit = 1 << 20, step = 64;
  return fmt::format("{}M", (plan.needs.bytes / unit / step + 1) * step);
}

std::string directive(const std::string& option) {
  return fmt::format("#SBATCH {}\n", option);
}

std::string common_directives(const SlurmPlan& plan) {
  std::string text = directive("--mem=" + memory_of(plan)) + directive("--ntasks=1") +
                     directive("--requeue") + directive("--open-mode=append");
  if (!plan.time.empty()) text += directive("--time=" + plan.time);  // some ask for it of every job
  if (!plan.partition.empty()) text += directive("--partition=" + plan.partition);
  for (const std::string& option : plan.directives) text += directive(option);
  return text;
}

std::string words(const std::vector<std::string>& options) {
  std::string text;
  for (const std::string& option : options) text += ' ' + shell_word(option);
  return text;
}

std::string command_line(const SlurmPlan& plan, const char* command) {
  std::string text =
      fmt::format("{} {} {} {}", shell_word(plan.program.string()), command,
                  shell_word(plan.scene.string()), shell_word("--output=" + plan.output));
  return text + words(plan.passed_on);
}

// Slurm puts numbers in the place of what follows a %.
std::string log_option(const SlurmPlan& plan, const char* name) {
  std::string path;
  for (const char c : plan.folder.string()) path += c == '%' ? "%%" : std::string(1, c);
  return fmt::format("--output={}/{}", path, name);
}

}  // namespace

std::string shell_word(std::string_view word) {
  const auto is_safe = [](char c) {
    return is_plain(c) || std::string_view("/=,:+").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_safe)) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

fs::path slurm_folder(const std::string& pattern) {
  return fs::path(pattern).parent_path() / (stem_of(pattern) + ".slurm");
}

std::string slurm_job_name(const std::string& pattern) {
  std::string name = "restframe-" + stem_of(pattern);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_plain(c); }, '_');
  return name;
}

std::string render_script(const SlurmPlan& plan) {
  std::string text = "#!/bin/sh\n";
  text += directive("--job-name=" + slurm_job_name(plan.output));
  text += directive(fmt::format("--array=0-{}", plan.tasks.size() - 1));
  text += directive(fmt::format("--cpus-per-task={}", plan.needs.cores));
  text += common_directives(plan);
  text += fmt::format(R"(
# The pictures of each task, from task 0 on.
set -- {}
shift "$SLURM_ARRAY_TASK_ID"
# Finished ones are kept: a task that is requeued goes on where it was.
exec {} \
  --threads="$SLURM_CPUS_PER_TASK" --pictures="$1"{}
)",
                      fmt::join(plan.tasks, " "), command_line(plan, "render"), words(plan.work));
  return text;
}

std::string check_script(const SlurmPlan& plan) {
  std::string text = "#!/bin/sh\n";
  text += directive("--job-name=" + slurm_job_name(plan.output) + "-check");
  text += directive("--cpus-per-task=1");
  text += common_directives(plan);
  text += "\nexec " + command_line(plan, "status");
  if (!plan.pictures.empty()) text += ' ' + shell_word("--pictures=" + plan.pictures);
  text += '\n';
  return text;
}

std::vector<std::string> render_arguments(const SlurmPlan& plan) {
  return {"--parsable", log_option(plan, "%A_%a.log"), (plan.folder / "render.sh").string()};
}

std::vector<std::string> check_arguments(const SlurmPlan& plan, const std::string& array_id) {
  return {"--parsable", "--dependency=afterany:" + array_id, log_option(plan, "check-%j.log"),
          (plan.folder / "check.sh").string()};
}

}  // namespace restframe

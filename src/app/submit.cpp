#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "app/child_process.h"
#include "app/commands.h"
#include "app/info_words.h"
#include "app/number_ranges.h"
#include "app/part_files.h"
#include "app/resume.h"
#include "app/slurm_queue.h"
#include "app/slurm_script.h"
#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/message.h"
#include "scene/parallel.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

fs::path this_program() {
  std::error_code error;
  fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) throw OutputError("/proc/self/exe: " + error.message());
  return program;
}

// The pictures of each task: `chunk` of them; 0: as many as give no more than a hundred tasks.
std::vector<std::string> tasks_for(std::span<const int> numbers, int chunk) {
  constexpr std::size_t most_tasks = 100;
  const std::size_t size =
      chunk > 0 ? static_cast<std::size_t>(chunk) : (numbers.size() + most_tasks - 1) / most_tasks;
  std::vector<std::string> tasks;
  for (std::size_t i = 0; i < numbers.size(); i += size) {
    tasks.push_back(ranges_text(numbers.subspan(i, std::min(size, numbers.size() - i)), ","));
  }
  return tasks;
}

SlurmPlan plan_of(const SubmitOptions& options, const Job& job, const std::vector<int>& numbers) {
  SlurmPlan plan;
  plan.program = this_program();
  plan.scene = fs::absolute(options.render.scene);
  plan.output = fs::absolute(job.scene.output.path).string();
  plan.folder = slurm_folder(plan.output);
  plan.passed_on = options.passed_on;
  plan.work = options.work;
  plan.pictures = options.pictures;
  plan.tasks = tasks_for(numbers, options.chunk);
  plan.needs = needs_of(job.scene, FrameSet(job.scene, thread_count()));
  if (options.render.threads > 0) plan.needs.cores = options.render.threads;
  plan.memory = options.memory;
  plan.time = options.time;
  plan.partition = options.partition;
  plan.directives = options.directives;
  return plan;
}

void check_folder(const fs::path& folder) {
  if (folder.string().find('\\') == std::string::npos) return;
  throw InputError(fmt::format(
      "output: {} has a backslash in it, which Slurm takes out of names; choose another folder",
      quote(folder.string())));
}

void write_scripts(const SlurmPlan& plan) {
  const auto write = [&](const char* name, const std::string& text) {
    write_file_atomically(plan.folder / name, [&](AtomicFile& file) { file.write(text); });
  };
  write("render.sh", render_script(plan));
  write("check.sh", check_script(plan));
}

std::string pictures_text(const SlurmPlan& plan, std::size_t count) {
  return fmt::format("{} in {}", count_of(count, "picture", "pictures"),
                     count_of(plan.tasks.size(), "task", "tasks"));
}

void print_command(const std::vector<std::string>& arguments) {
  fmt::print("sbatch");
  for (const std::string& argument : arguments) fmt::print(" {}", shell_word(argument));
  fmt::print("\n");
}

// Returns Slurm's number of the job.
std::string submitted(const fs::path& sbatch, const std::vector<std::string>& arguments,
                      const std::string& so_far) {
  const ChildResult result = run_child(sbatch, arguments, [] { return std::string(); });
  const auto id = submitted_id(result.last_lines);
  if (!result.succeeded || !id) {
    throw OutputError(fmt::format("sbatch failed, {}: {}", so_far, words_of(result)));
  }
  return *id;
}

fs::path checked_sbatch() {
  const auto sbatch = program_on_path("sbatch");
  if (sbatch) return *sbatch;
  throw OutputError(
      "submit: sbatch is not on the PATH, nothing was submitted; run this where Slurm's commands "
      "are "
      "(on Debian: package slurm-client), or only write the scripts with --dry-run");
}

void submit_plan(const SlurmPlan& plan, const fs::path& sbatch, std::size_t count) {
  const std::string what = pictures_text(plan, count);
  const std::string array = submitted(sbatch, render_arguments(plan), "nothing was submitted");
  record_array(plan.folder, array, what);
  const std::string check =
      submitted(sbatch, check_arguments(plan, array),
                fmt::format("array {} was submitted, but not what checks it", array));
  fmt::print("array {}: {}; then job {} says what is missing; logs in {}\n", array, what, check,
             plan.folder.string());
}

// Two arrays for the same pictures would make each twice.
void check_queue(const fs::path& folder, const std::string& pattern) {
  const std::vector<std::string> arrays = recorded_arrays(folder);
  const auto squeue = program_on_path("squeue");
  if (arrays.empty() || !squeue) return;
  const QueueCounts queue = queue_counts(*squeue, slurm_job_name(pattern), arrays);
  if (queue.running + queue.waiting == 0) return;
  throw InputError(
      fmt::format("submit: of the arrays submitted before, {} tasks run and {} wait; `restframe "
                  "status` tells when they are done, scancel ends them (arrays {})",
                  queue.running, queue.waiting, fmt::join(arrays, ", ")));
}

}  // namespace

int submit(const SubmitOptions& options, const ImportLimits& limits) {
  const Job job = loaded_job(options.render, limits);
  const ToMake to_make = what_to_make(job, options.render.overwrite);
  std::vector<int> numbers;
  std::merge(to_make.pictures.begin(), to_make.pictures.end(), to_make.previews.begin(),
             to_make.previews.end(), std::back_inserter(numbers));
  if (numbers.empty()) {
    fmt::print("all {} pictures are there already; nothing was submitted\n", job.numbers.size());
    return 0;
  }
  if (!options.render.overwrite) pictures_with_tiles_to_make(job, numbers, std::nullopt);
  const std::string pattern = fs::absolute(job.scene.output.path).string();
  check_folder(slurm_folder(pattern));
  const fs::path sbatch = options.dry_run ? fs::path() : checked_sbatch();
  if (!options.dry_run) check_queue(slurm_folder(pattern), pattern);
  const SlurmPlan plan = plan_of(options, job, numbers);
  write_scripts(plan);
  if (!options.dry_run) {
    submit_plan(plan, sbatch, numbers.size());
    return 0;
  }
  print_command(render_arguments(plan));
  print_command(check_arguments(plan, "ARRAY"));
  return 0;
}

}  // namespace restframe

#include <fmt/format.h>

#include <algorithm>

#include "app/child_process.h"
#include "app/commands.h"
#include "app/number_ranges.h"
#include "app/picture_files.h"
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

std::vector<int> tasks_for(const std::vector<int>& numbers, int first, int chunk) {
  std::vector<int> tasks;
  for (const int number : numbers) {
    const int task = (number - first) / chunk;
    if (tasks.empty() || tasks.back() != task) tasks.push_back(task);
  }
  return tasks;
}

int chunk_of(const SubmitOptions& options, const PictureRange& range) {
  constexpr int most_tasks = 100;
  const int count = range.last - range.first + 1;
  return options.chunk > 0 ? std::min(options.chunk, count) : (count + most_tasks - 1) / most_tasks;
}

SlurmPlan plan_of(const SubmitOptions& options, const Job& job, const std::vector<int>& numbers) {
  SlurmPlan plan;
  plan.program = this_program();
  plan.scene = fs::absolute(options.render.scene);
  plan.output = fs::absolute(job.scene.output.path).string();
  plan.folder = slurm_folder(plan.output);
  plan.passed_on = options.passed_on;
  plan.range = job.range;
  plan.chunk = chunk_of(options, job.range);
  plan.tasks = tasks_for(numbers, job.range.first, plan.chunk);
  plan.overwrite = options.render.overwrite;
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
  return fmt::format("{} {} of {}-{} in {} {} of {}", count, count == 1 ? "picture" : "pictures",
                     plan.range.first, plan.range.last, plan.tasks.size(),
                     plan.tasks.size() == 1 ? "task" : "tasks", plan.chunk);
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

}  // namespace

int submit(const SubmitOptions& options, const ImportLimits& limits) {
  const Job job = loaded_job(options.render, limits);
  const std::vector<int> numbers =
      pictures_to_make(job.scene, job.range.first, job.range.last, options.render.overwrite);
  if (numbers.empty()) {
    fmt::print("all {} pictures are there already; nothing was submitted\n",
               job.range.last - job.range.first + 1);
    return 0;
  }
  check_folder(slurm_folder(fs::absolute(job.scene.output.path).string()));
  const fs::path sbatch = options.dry_run ? fs::path() : checked_sbatch();
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

#include "app/options_submit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "scene/error.h"
#include "scene/message.h"

namespace restframe {
namespace {

// What submit reads itself; every other option it hands on as it is.
constexpr std::array own_options = {"--help",      "--slurm",   "--chunk",   "--time",
                                    "--partition", "--memory",  "--sbatch",  "--dry-run",
                                    "--output",    "--threads", "--pictures"};
// What `restframe status` has no use for.
constexpr std::array work_options = {"--checkpoint", "--overwrite"};

bool is_among(const std::string& name, std::span<const char* const> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> passed_on(const CLI::App& command, bool of_work) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || option->get_positional()) continue;
    if (is_among(name, own_options) || is_among(name, work_options) != of_work) continue;
    const bool is_flag = option->get_expected_max() == 0;
    words.push_back(is_flag ? name : name + "=" + option->results().back());
  }
  return words;
}

// Slurm reads options in a script's comments by rules of its own for quotes and blanks.
void check_word(const char* option, const std::string& word, std::string_view characters) {
  const auto fits = [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           characters.find(c) != std::string_view::npos;
  };
  if (std::all_of(word.begin(), word.end(), fits)) return;
  throw InputError(
      fmt::format("{}: {} must be letters, digits and {}", option, quote(word), characters));
}

}  // namespace

CLI::App* add_submit(CLI::App& app, SubmitOptions& submit) {
  CLI::App* command = app.add_subcommand(
      "submit", "Have a cluster render the pictures that are missing: a Slurm job array");
  command->add_flag("--slurm", submit.by_slurm, "By Slurm, the one scheduler that is known")
      ->required();
  command
      ->add_option("--chunk", submit.chunk,
                   "Pictures a task; unless given, as many as make 100 tasks at most")
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--time", submit.time,
                      "The longest time of a task, as sbatch has it: 2:00:00");
  command->add_option("--partition", submit.partition, "The partition of the cluster");
  command->add_option("--memory", submit.memory,
                      "Memory of a task, as 8G; unless given, what the scene needs");
  command
      ->add_option("--sbatch", submit.directives,
                   "A further option of sbatch, as --sbatch=--account=film; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--dry-run", submit.dry_run,
                    "Write the scripts and print the commands, submit nothing");
  return command;
}

CLI::App* add_status(CLI::App& app, StatusOptions& status) {
  CLI::App* command =
      app.add_subcommand("status", "Say which pictures are finished; exit code 3 while any is not");
  command->add_flag("--json", status.json, "As JSON, for programs; see scenes/reference.md");
  return command;
}

SubmitOptions completed(SubmitOptions options, const RenderOptions& render,
                        const CLI::App& command) {
  options.render = render;
  options.passed_on = passed_on(command, false);
  options.work = passed_on(command, true);
  const CLI::Option* pictures = command.get_option("--pictures");
  if (pictures->count() > 0) options.pictures = pictures->results().back();
  check_word("--time", options.time, ":-");
  check_word("--partition", options.partition, "_-.,");
  check_word("--memory", options.memory, "");
  for (const std::string& directive : options.directives) {
    check_word("--sbatch", directive, "_-.,:=/+@&|*[]()");
    if (!directive.starts_with("--")) {
      throw InputError(
          fmt::format("--sbatch: {} must be a long option, as --account=film", quote(directive)));
    }
  }
  return options;
}

StatusOptions completed(StatusOptions options, const RenderOptions& render) {
  options.render = render;
  return options;
}

}  // namespace restframe

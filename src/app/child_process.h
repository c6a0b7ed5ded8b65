#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace restframe {

// Where a program of this name is on the PATH; nothing where it is not installed.
std::optional<std::filesystem::path> program_on_path(std::string_view name);

struct ChildResult {
  bool succeeded = false;  // exit code 0, and it took all its input
  std::string last_lines;  // of its standard output and error, the last of its characters
};

// The last lines as part of a message.
std::string words_of(const ChildResult& result);

// Gives the next piece of a program's standard input; an empty one ends it.
using NextInput = std::function<std::string()>;

// Runs a program with these arguments (its name not among them), without a shell, and waits for its
// end. Throws OutputError if it can not be started, and Interrupted, with the program and what it
// started ended, when a signal came. kept: how many characters of its output.
ChildResult run_child(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, const NextInput& next_input,
                      std::size_t kept = 500);

// Ends the program that run_child() runs, and what it started, without a word: for a process that is
// about to end itself.
void kill_running_child();

}  // namespace restframe

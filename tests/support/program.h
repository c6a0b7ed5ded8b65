#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace restframe {

struct RunOptions {
  std::filesystem::path folder{};  // the current folder of the program; empty: the test's own
  // After this long the program gets `signal`; after five seconds more, SIGKILL.
  std::chrono::milliseconds timeout{60000};
  int signal = SIGKILL;
  std::optional<std::uint64_t>
      largest_file{};                     // bytes: a write beyond fails, as on a full disk (EFBIG)
  std::optional<std::uint64_t> memory{};  // bytes of address space
  std::optional<std::string> path_variable{};  // PATH; else the test's own
};

struct RunResult {
  int exit_code = -1;         // -1 if a signal ended it
  std::optional<int> signal;  // that ended it
  bool timed_out = false;
  std::string out, error;  // standard output and standard error
  std::chrono::milliseconds duration{0};
};

// Runs a program with these arguments (its name not among them), without a shell and with an empty
// standard input, and waits for its end. Exit code 127 if it cannot be started. Throws
// std::runtime_error if the system gives no pipe or process.
RunResult run_program(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace restframe

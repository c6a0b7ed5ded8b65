#pragma once

// For tests of what strangers' files can do to the program: it runs as a process, under a limit of
// memory and time.

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;  // needs terabytes of address space
#elif defined(__has_feature)
inline constexpr bool is_sanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

class Hostile : public ::testing::Test {
 protected:
  RunResult run(const std::vector<std::string>& arguments) const {
    RunOptions options;
    options.folder = folder.path();
    options.timeout = std::chrono::seconds(is_sanitized ? 60 : 10);
    if (!is_sanitized) options.memory = std::uint64_t{3} << 30;
    return run_program(RESTFRAME_PROGRAM, arguments, options);
  }

  RunResult render(const std::string& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"render", file,  "--quiet",   "--output", "out/#.exr",
                                          "--size", "8x8", "--samples", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  // Exit code 2, no signal, no output, and one line of error: "error: FILE:" and then `begin`, with
  // `part` further on. Warnings may come before it.
  void expect_refused(const std::string& file, const std::string& begin,
                      const std::string& part = "",
                      const std::vector<std::string>& more = {}) const {
    SCOPED_TRACE(file);
    const RunResult result = render(file, more);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_FALSE(result.signal.has_value());
    EXPECT_FALSE(result.timed_out);
    const std::size_t error = result.error.find("error: ");
    ASSERT_NE(error, std::string::npos) << result.error;
    const std::string line = result.error.substr(error);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
    EXPECT_THAT(line, ::testing::StartsWith("error: " + file + ":" + begin));
    EXPECT_THAT(line, ::testing::HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
  }

  // It renders, with a warning that holds the text; none where that is empty.
  void expect_rendered(const std::string& file, const std::string& warning = "") const {
    SCOPED_TRACE(file);
    const RunResult result = render(file, {"--overwrite"});
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_EQ(result.error.empty(), warning.empty()) << result.error;
    EXPECT_THAT(result.error, ::testing::HasSubstr(warning));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/0.exr"));
    std::filesystem::remove_all(folder.path() / "out");
  }

  TemporaryFolder folder;
};

}  // namespace restframe::test

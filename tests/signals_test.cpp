// SIGTERM and SIGINT while something works that does not look at them: reading an asset, building Embree's
// scenes, encoding a picture. Here it sleeps.

#include "app/signals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "app/child_process.h"
#include "scene/atomic_file.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using namespace std::chrono_literals;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

[[noreturn]] void be_busy() {
  while (true) std::this_thread::sleep_for(1h);
}

[[noreturn]] void be_interrupted_while_writing(const fs::path& path, int signal) {
  catch_signals();
  AtomicFile file(path);
  file.write(std::string(1'000'000, 'x'));
  std::raise(signal);
  std::raise(signal);
  be_busy();
}

TEST(SignalsDeathTest, EndWhatDoesNotLookAndLeaveNothingHalfWritten) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const TemporaryFolder folder;
    folder.write("a.exr", "before");
    EXPECT_EXIT(be_interrupted_while_writing(folder.path() / "a.exr", signal),
                testing::ExitedWithCode(130), "^error: interrupted[^\n]*\n$");
    EXPECT_THAT(names_in(folder.path()), ElementsAre("a.exr"));
    EXPECT_EQ(fs::file_size(folder.path() / "a.exr"), 6U);
  }
}

[[noreturn]] void be_interrupted_beside_a_child(const fs::path& place) {
  catch_signals();
  run_child("/bin/sh", {"-c", "echo $$ > \"$0\"; exec sleep 600", place.string()}, [&] {
    while (fs::exists(place) ? fs::file_size(place) == 0 : true) std::this_thread::sleep_for(5ms);
    std::raise(SIGTERM);
    be_busy();
    return std::string();
  });
  std::abort();
}

TEST(SignalsDeathTest, EndTheProgramThatIsWaitedFor) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "process.txt";
  EXPECT_EXIT(be_interrupted_beside_a_child(place), testing::ExitedWithCode(130), "interrupted");
  pid_t process = 0;
  ASSERT_TRUE(std::ifstream(place) >> process);
  // Its new parent may take a moment to notice.
  for (int i = 0; i < 500 && kill(process, 0) == 0; ++i) std::this_thread::sleep_for(10ms);
  std::ifstream status("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  if (status >> number >> name >> state) {
    EXPECT_EQ(state, "Z");
  }
}

[[noreturn]] void be_interrupted_where_somebody_looks() {
  catch_signals();
  std::raise(SIGTERM);
  std::exit(interrupt_requested() ? report_interruption() : 1);
}

TEST(SignalsDeathTest, AreSeenAtOnceByWhoeverLooks) {
  EXPECT_EXIT(be_interrupted_where_somebody_looks(), testing::ExitedWithCode(130),
              "^error: interrupted[^\n]*\n$");
}

}  // namespace
}  // namespace restframe

// The inputs that once showed a defect, and the fuzzers' own seeds, read again through the fuzzers'
// entry points.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "fuzz/targets.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;

const fs::path fuzz_folder = fs::path(RESTFRAME_SOURCE_DIR) / "tests/fuzz";

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class FuzzCorpus : public ::testing::TestWithParam<fuzz::Target> {};

TEST_P(FuzzCorpus, IsReadWithoutADefect) {
  const fuzz::InputFolder folder;
  for (const char* kind : {"seeds", "corpus"}) {
    for (const fs::path& file : files_in(fuzz_folder / kind / GetParam().name)) {
      EXPECT_NO_THROW(fuzz::read(GetParam(), folder, content_of(file))) << file;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, FuzzCorpus, ::testing::ValuesIn(fuzz::targets()),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(FuzzTargets, AreThereForEveryFolder) {
  for (const char* kind : {"seeds", "corpus"}) {
    for (const fs::path& folder : files_in(fuzz_folder / kind)) {
      EXPECT_NO_THROW(fuzz::find_target(folder.filename().string())) << folder;
    }
  }
}

TEST(FuzzTargets, HaveSeeds) {
  for (const fuzz::Target& target : fuzz::targets()) {
    EXPECT_THAT(files_in(fuzz_folder / "seeds" / target.name), ::testing::Not(::testing::IsEmpty()))
        << target.name;
  }
}

}  // namespace
}  // namespace restframe

// `restframe status`: which pictures are finished, and what a cluster does about the others.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/number_ranges.h"
#include "support/cluster_job.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Status : public testing::Test {
 protected:
  void render(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"render", "scene.toml", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = job_.run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.error;
  }
  // Of seven pictures: 0 and 6 finished, 1, 3 and 4 missing, 2 torn, 5 of another scene.
  void make_some() const {
    for (const char* pictures : {"0", "2", "6"}) render({"-p", pictures});
    render({"-p", "5", "--samples", "3"});
    fs::resize_file(job_.path("out/p $x.02.exr"), fs::file_size(job_.path("out/p $x.02.exr")) - 20);
  }
  // As `restframe submit` leaves it.
  void record(const std::string& lines) const { job_.write("out/p $x.slurm/arrays.txt", lines); }
  const ClusterJob job_;
};

TEST(NumberRanges, JoinNeighbours) {
  const auto text = [](const std::vector<int>& numbers) { return ranges_text(numbers); };
  EXPECT_EQ(text({}), "");
  EXPECT_EQ(text({4}), "4");
  EXPECT_EQ(text({3, 4, 5, 6, 7, 12}), "3-7, 12");
  EXPECT_EQ(text({0, 2, 4, 5}), "0, 2, 4-5");
  EXPECT_EQ(ranges_text(std::vector{0, 1, 3}, ","), "0-1,3");
}

TEST_F(Status, ListsWhatIsNotFinished) {
  const RunResult before = job_.run({"status", "scene.toml"});
  EXPECT_EQ(before.exit_code, 3);
  EXPECT_EQ(before.out, "out/p $x.##.exr: 0 of 7 pictures finished\nmissing: 0-6\n");
  EXPECT_EQ(before.error, "");
  make_some();
  const RunResult some = job_.run({"status", "scene.toml"});
  EXPECT_EQ(some.exit_code, 3);
  EXPECT_THAT(some.out, testing::StartsWith("out/p $x.##.exr: 2 of 7 pictures finished\n"
                                            "missing: 1, 3-4\n"
                                            "torn: 2\n"
                                            "of another scene: 5 ("));
  EXPECT_THAT(some.out, HasSubstr("samples"));
  EXPECT_EQ(job_.run({"status", "scene.toml", "-p", "6"}).exit_code, 0);
  render({"--overwrite"});
  const RunResult all = job_.run({"status", "scene.toml"});
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_EQ(all.out, "out/p $x.##.exr: 7 of 7 pictures finished\n");
}

TEST_F(Status, IsAboutThePicturesOfTheSameOptions) {
  render({"--samples", "2", "-o", "other/p.##.exr"});
  EXPECT_EQ(job_.run({"status", "scene.toml", "-o", "other/p.##.exr"}).exit_code, 3);
  EXPECT_EQ(job_.run({"status", "scene.toml", "-o", "other/p.##.exr", "--samples", "2"}).exit_code,
            0);
  EXPECT_EQ(job_.run({"status", "scene.toml", "--pictures", "9"}).exit_code, 2);
  EXPECT_EQ(job_.run({"status", "none.toml"}).exit_code, 2);
}

TEST_F(Status, ChangesNothing) {
  make_some();
  const std::string torn = job_.content("out/p $x.02.exr");
  job_.run({"status", "scene.toml"});
  EXPECT_EQ(job_.content("out/p $x.02.exr"), torn);
  EXPECT_FALSE(fs::exists(job_.path("out/p $x.01.exr")));
  job_.run({"status", "scene.toml", "-o", "nowhere/p.##.exr"});
  EXPECT_FALSE(fs::exists(job_.path("nowhere")));
}

TEST_F(Status, SpeaksJson) {
  make_some();
  record("77 seven\n");
  job_.install("squeue", "#!/bin/sh\necho PENDING\n");
  const RunResult result = job_.run({"status", "scene.toml", "--json"});
  EXPECT_EQ(result.exit_code, 3);
  using Ranges = std::vector<std::vector<int>>;
  const nlohmann::json document = nlohmann::json::parse(result.out);
  EXPECT_EQ(document["output"], "out/p $x.##.exr");
  EXPECT_EQ(document["finished"], (Ranges{{0, 0}, {6, 6}}));
  EXPECT_EQ(document["missing"], (Ranges{{1, 1}, {3, 4}}));
  EXPECT_EQ(document["torn"], (Ranges{{2, 2}}));
  EXPECT_EQ(document["of_another_scene"], (Ranges{{5, 5}}));
  EXPECT_THAT(document["difference"].get<std::string>(), HasSubstr("samples"));
  EXPECT_EQ(document["slurm"]["running"], 0);
  EXPECT_EQ(document["slurm"]["waiting"], 1);
}

TEST_F(Status, CountsTheTasksOfTheCluster) {
  job_.install("squeue",
               "#!/bin/sh\nprintf '%s\\n' \"$@\" > calls.txt\n"
               "printf 'RUNNING\\nPENDING\\nPENDING\\nCOMPLETED\\nRUNNING\\nREQUEUED\\n'\n");
  EXPECT_THAT(job_.run({"status", "scene.toml"}).out, Not(HasSubstr("slurm")));
  EXPECT_FALSE(fs::exists(job_.path("calls.txt")));
  record("77 7 pictures\nnonsense\n80 2 pictures\n");
  const RunResult result = job_.run({"status", "scene.toml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, HasSubstr("\nslurm: 2 running, 3 waiting\n"));
  EXPECT_EQ(job_.content("calls.txt"),
            "--noheader\n--array\n--format=%T\n--name=restframe-p__x\n--jobs=77,80\n");
}

TEST_F(Status, CountsMoreTasksThanAMessageHolds) {
  record("77\n");
  job_.install("squeue",
               "#!/bin/sh\ni=0\nwhile [ $i -lt 2000 ]; do echo PENDING; i=$((i + 1)); done\n");
  EXPECT_THAT(job_.run({"status", "scene.toml"}).out, HasSubstr("slurm: 0 running, 2000 waiting"));
}

TEST_F(Status, DoesWithoutTheCluster) {
  record("77\n");
  EXPECT_THAT(job_.run({"status", "scene.toml"}).out, Not(HasSubstr("slurm")));
  job_.install("squeue",
               "#!/bin/sh\necho 'slurm_load_jobs error: Invalid job id specified' >&2\nexit 1\n");
  EXPECT_THAT(job_.run({"status", "scene.toml"}).out, HasSubstr("slurm: 0 running, 0 waiting"));
  job_.install("squeue", "#!/bin/sh\necho 'Unable to contact slurm controller' >&2\nexit 1\n");
  const RunResult result = job_.run({"status", "scene.toml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, HasSubstr("slurm: squeue failed: Unable to contact slurm controller"));
  render({});
  EXPECT_EQ(job_.run({"status", "scene.toml"}).exit_code, 0);
}

}  // namespace
}  // namespace restframe

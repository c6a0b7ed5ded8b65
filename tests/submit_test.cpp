// `restframe submit --slurm`: the scripts, what sbatch is told, and what happens when it fails, is
// missing or has nothing to do. A script stands in for it; tests/cluster.sh has the real one.

#include "app/slurm_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "app/slurm_queue.h"
#include "support/cluster_job.h"
#include "support/program_errors.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kFolder = "out/p $x.slurm";
const std::string kRenderScript = std::string(kFolder) + "/render.sh";

class Submit : public testing::Test {
 protected:
  RunResult submit(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"submit", "--slurm", "scene.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return job_.run(arguments);
  }
  const ClusterJob job_;
};

TEST(ShellWord, IsWhatAShellReads) {
  for (const char* word : {"plain", "", "a b", "it's", "''", "\"$HOME\" `id` \\ !",
                           "a\nb\t*?[x]~#;&|", "--output=/a/b.####.exr", "Zeitdilatation ä"}) {
    const RunResult result = run_program("/bin/sh", {"-c", "printf %s " + shell_word(word)});
    EXPECT_EQ(result.out, word);
  }
  EXPECT_EQ(shell_word("/usr/bin/restframe"), "/usr/bin/restframe");
}

TEST(SlurmFolder, IsNamedLikeThePictures) {
  EXPECT_EQ(slurm_folder("out/shot.####.exr"), "out/shot.slurm");
  EXPECT_EQ(slurm_folder("shot_##_left.exr"), "shot__left.slurm");
  EXPECT_EQ(slurm_folder("/a/####.exr"), "/a/pictures.slurm");
  EXPECT_EQ(slurm_job_name("out/a b's.##.exr"), "restframe-a_b_s");
}

TEST(SubmittedId, IsReadAmongOtherLines) {
  EXPECT_EQ(submitted_id("123"), "123");
  EXPECT_EQ(submitted_id("sbatch: warning: 5\n123;cluster\n"), "123");
  EXPECT_EQ(submitted_id("sbatch: error: 1 2"), std::nullopt);
  EXPECT_EQ(submitted_id(""), std::nullopt);
}

// The words on lines that Slurm reads: those before the first that is no comment.
std::vector<std::string> directives(const std::string& script) {
  std::vector<std::string> words;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line) && line.rfind('#', 0) == 0;) {
    if (line.rfind("#SBATCH ", 0) == 0) words.push_back(line.substr(8));
  }
  return words;
}

TEST_F(Submit, WritesAnArrayOfChunks) {
  const RunResult result = submit({"--dry-run", "--chunk", "3", "--time", "1-02:00:00",
                                   "--partition=fast,slow", "--memory", "3G", "--threads", "6",
                                   "--sbatch=--account=film", "--sbatch", "--qos=low"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(directives(job_.content(kRenderScript)),
              testing::UnorderedElementsAre(
                  "--job-name=restframe-p__x", "--array=0-2", "--cpus-per-task=6", "--ntasks=1",
                  "--mem=3G", "--requeue", "--open-mode=append", "--time=1-02:00:00",
                  "--partition=fast,slow", "--account=film", "--qos=low"));
  EXPECT_THAT(directives(job_.content(std::string(kFolder) + "/check.sh")),
              testing::UnorderedElementsAre(
                  "--job-name=restframe-p__x-check", "--cpus-per-task=1", "--ntasks=1", "--mem=3G",
                  "--requeue", "--open-mode=append", "--time=1-02:00:00", "--partition=fast,slow",
                  "--account=film", "--qos=low"));
  EXPECT_THAT(result.out, HasSubstr("sbatch --parsable --dependency=afterany:ARRAY "));
  EXPECT_FALSE(fs::exists(job_.path(std::string(kFolder) + "/arrays.txt")));
}

TEST_F(Submit, DoesNotSubmitWhatIsInTheQueue) {
  job_.install("sbatch", "#!/bin/sh\necho 77\n");
  ASSERT_EQ(submit().exit_code, 0);
  job_.install("squeue", "#!/bin/sh\nprintf 'RUNNING\\nPENDING\\nPENDING\\n'\n");
  expect_error(submit(), 2, {"1 tasks run and 2 wait", "arrays 77"});
  job_.install("squeue", "#!/bin/sh\necho COMPLETED\n");
  EXPECT_EQ(submit().exit_code, 0);
}

// 256 MB, and more for larger pictures; no more cores than tiles of 32 x 32 pixels.
TEST_F(Submit, AsksForWhatTheSceneNeeds) {
  ASSERT_EQ(submit({"--dry-run"}).exit_code, 0);
  const std::string small = job_.content(kRenderScript);
  EXPECT_THAT(small, HasSubstr("\n#SBATCH --mem=256M\n"));
  EXPECT_THAT(small, HasSubstr("\n#SBATCH --cpus-per-task=1\n"));
  EXPECT_THAT(small, HasSubstr("\nset -- 0 1 2 3 4 5 6\n"));
  ASSERT_EQ(submit({"--dry-run", "--size", "20000x10000"}).exit_code, 0);
  const std::string large = job_.content(kRenderScript);
  // Two pictures of R, G, B, A and Z in float, 20 bytes a pixel, are 8 GB: 4 cores' worth.
  const std::size_t at = large.find("--mem=");
  ASSERT_NE(at, std::string::npos);
  EXPECT_GT(std::stoi(large.substr(at + 6)), 8000);
  EXPECT_THAT(large, Not(HasSubstr("--cpus-per-task=1\n")));
}

TEST_F(Submit, TasksMakeThePicturesOfOneRun) {
  ASSERT_EQ(submit({"--dry-run", "--chunk", "3", "--samples", "2", "--exposure", "-3",
                    "--checkpoint", "60"})
                .exit_code,
            0);
  for (const int task : {2, 0, 1}) {
    const RunResult made = job_.run_task(kRenderScript, task);
    ASSERT_EQ(made.exit_code, 0) << made.error;
    EXPECT_THAT(made.out, HasSubstr(task == 2 ? "1 of 1 pictures made" : "3 of 3 pictures made"));
  }
  ASSERT_EQ(job_.run({"render", "scene.toml", "-o", "local/p $x.##.exr", "--samples", "2",
                      "--exposure", "-3", "--quiet"})
                .exit_code,
            0);
  for (int number = 0; number < 7; ++number) {
    for (const char* extension : {".exr", ".png"}) {
      const std::string name = "/p $x.0" + std::to_string(number) + extension;
      ASSERT_FALSE(job_.content("local" + name).empty());
      EXPECT_EQ(job_.content("out" + name), job_.content("local" + name)) << name;
    }
  }
  const auto status = job_.run_task(std::string(kFolder) + "/check.sh", 0);
  EXPECT_EQ(status.exit_code, 0) << status.error;
  EXPECT_THAT(status.out, HasSubstr("7 of 7 pictures finished"));
}

TEST_F(Submit, TellsSbatchWhereLogsGoAndWhatToWaitFor) {
  job_.install("sbatch", kRecordingSbatch);
  const RunResult result = submit({"--chunk", "4"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("array 77: 7 pictures in 2 tasks; then job 78"));
  std::string logs = job_.path(kFolder).string();
  logs.insert(logs.find('%'), 1, '%');
  const std::string folder = job_.path(kFolder).string();
  EXPECT_EQ(job_.content("calls.txt"), "--parsable\n--output=" + logs + "/%A_%a.log\n" + folder +
                                           "/render.sh\n--parsable\n--dependency=afterany:77\n" +
                                           "--output=" + logs + "/check-%j.log\n" + folder +
                                           "/check.sh\n");
  EXPECT_THAT(job_.content(std::string(kFolder) + "/arrays.txt"), HasSubstr("77 "));
}

TEST_F(Submit, LeavesOutWhatIsThere) {
  job_.install("sbatch", kRecordingSbatch);
  for (const char* made : {"0-2", "4", "6"}) {
    ASSERT_EQ(job_.run({"render", "scene.toml", "-p", made, "-q"}).exit_code, 0);
  }
  const auto tasks = [&](const std::vector<std::string>& options) {
    const RunResult result = submit(options);
    EXPECT_EQ(result.exit_code, 0) << result.error;
    const std::string script = job_.content(kRenderScript);
    const std::size_t at = script.find("set -- ");
    return script.substr(at, script.find('\n', at) - at);
  };
  EXPECT_EQ(tasks({"--chunk", "1"}), "set -- 3 5");
  EXPECT_THAT(directives(job_.content(kRenderScript)), testing::Contains("--array=0-1"));
  EXPECT_EQ(tasks({"--chunk", "2"}), "set -- 3,5");
  EXPECT_EQ(tasks({"--pictures", "4-6"}), "set -- 5");
  EXPECT_THAT(job_.content(std::string(kFolder) + "/check.sh"), HasSubstr(" --pictures=4-6\n"));
  EXPECT_EQ(tasks({"--overwrite", "--chunk", "4"}), "set -- 0-3 4-6");
  EXPECT_EQ(tasks({"--overwrite", "--chunk", "2", "-p", "0-6:3"}), "set -- 0,3 6");
  EXPECT_THAT(job_.content(kRenderScript), HasSubstr("\"$1\" --overwrite\n"));
  EXPECT_EQ(tasks({"--chunk", "2", "-p", "2-3,0,5"}), "set -- 3,5");
  ASSERT_EQ(job_.run_task(kRenderScript, 0).exit_code, 0);
  fs::remove(job_.path("calls.txt"));
  const RunResult nothing = submit();
  EXPECT_EQ(nothing.exit_code, 0);
  EXPECT_THAT(nothing.out, HasSubstr("all 7 pictures are there already; nothing was submitted"));
  EXPECT_FALSE(fs::exists(job_.path("calls.txt")));
}

TEST_F(Submit, NothingIsSubmittedThatCanNotBeRendered) {
  job_.install("sbatch", kRecordingSbatch);
  expect_error(job_.run({"submit", "scene.toml"}), 2, {"--slurm"});
  expect_error(submit({"--time", "1:00 --wrap=x"}), 2, {"--time", "\"1:00 --wrap=x\""});
  expect_error(submit({"--partition", "a\nb"}), 2, {"--partition"});
  expect_error(submit({"--memory", "3 G"}), 2, {"--memory"});
  expect_error(submit({"--sbatch", "account=film"}), 2, {"--sbatch", "long option"});
  expect_error(submit({"--sbatch", "--comment=a b"}), 2, {"--sbatch"});
  expect_error(submit({"--chunk", "0"}), 2, {"--chunk"});
  expect_error(submit({"--pictures", "3-9"}), 2, {"no picture 9"});
  expect_error(submit({"-o", "out\\x/p.##.exr"}), 2, {"backslash"});
  expect_error(submit({"-o", "out/p.exr"}), 2, {"path"});
  ASSERT_EQ(job_.run({"render", "scene.toml", "-p", "5", "-q"}).exit_code, 0);
  expect_error(submit({"--samples", "2"}), 2, {"05.exr: was made from another scene"});
  std::string scene = kClusterScene;
  job_.write("scene.toml", scene.replace(scene.find("0.5]"), 4, "1.5]"));
  expect_error(submit(), 2, {"scene.toml:", "velocity"});
  EXPECT_FALSE(fs::exists(job_.path("calls.txt")));
  EXPECT_FALSE(fs::exists(job_.path(kFolder)));
}

TEST_F(Submit, SaysWhatSbatchLacksOrSaid) {
  expect_error(submit(), 3, {"sbatch is not on the PATH", "slurm-client", "--dry-run"});
  EXPECT_FALSE(fs::exists(job_.path(kFolder)));
  job_.install("sbatch", "#!/bin/sh\necho 'sbatch: error: invalid partition' >&2\nexit 1\n");
  expect_error(submit(), 3, {"nothing was submitted: sbatch: error: invalid partition"});
  job_.install("sbatch", "#!/bin/sh\necho queued\n");
  expect_error(submit(), 3, {"nothing was submitted: queued"});
  job_.install("sbatch", "#!/bin/sh\ncase $* in *afterany*) exit 1 ;; *) echo 77 ;; esac\n");
  expect_error(submit(), 3, {"array 77 was submitted", "it said nothing"});
  EXPECT_THAT(job_.content(std::string(kFolder) + "/arrays.txt"), HasSubstr("77 "));
}

}  // namespace
}  // namespace restframe

// `restframe render --video`: what ffmpeg is given, and what happens when it fails, is missing, or
// is interrupted. A script stands in for it: it keeps its arguments, and its film is what it was
// given.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <sys/types.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "app/child_process.h"
#include "app/video.h"
#include "scene/error.h"
#include "support/program_errors.h"
#include "support/scene_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kScene = R"(
[camera]
position = [0, 0, 4]
[animation]
rate = 12.5
pictures = 4
[render]
resolution = [31, 25]
samples = 1
[output]
path = "p.##.exr"
[[object]]
sphere = {radius = 1, fineness = 2}
velocity = [0, 0, 0.5]
)";

constexpr const char* kRecorder = R"(#!/bin/sh
printf '%s\n' "$@" > arguments.txt
for last; do :; done
exec /bin/cat > "$last"
)";

class Video : public testing::Test, public SceneFolder {
 protected:
  Video() : SceneFolder(kScene) {}

  void install(const std::string& script) const {
    write("bin/ffmpeg", script);
    fs::permissions(path("bin/ffmpeg"), fs::perms::owner_all);
  }
  RunResult render(const std::vector<std::string>& more, RunOptions options = {}) const {
    if (!options.path_variable) options.path_variable = "/nowhere::" + path("bin").string();
    return SceneFolder::render(more, options);
  }
  std::string pngs(int first, int last) const {
    std::string all;
    for (int i = first; i <= last; ++i) all += content(fmt::format("p.{:02}.png", i));
    return all;
  }
  // Of the folder "film", hidden ones too.
  std::vector<std::string> files_beside_film() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path("film"))) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }
};

TEST_F(Video, HandsThePicturesInOrderAtTheScenesRate) {
  install(kRecorder);
  const RunResult result = render({"--video", "film/a b.mp4"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("film/a b.mp4: 4 pictures, 12.5 a second"));
  EXPECT_TRUE(content("film/a b.mp4") == pngs(0, 3));
  EXPECT_THAT(files_beside_film(), testing::ElementsAre("a b.mp4"));
  const std::string arguments = content("arguments.txt");
  EXPECT_THAT(arguments, HasSubstr("-framerate\n12.5\n"));
  EXPECT_THAT(arguments, HasSubstr("-pix_fmt\nyuv420p\n"));
  EXPECT_THAT(arguments, HasSubstr("pad=ceil(iw/2)*2:ceil(ih/2)*2"));
}

TEST_F(Video, IsMadeOfPicturesThatWereThere) {
  install(kRecorder);
  ASSERT_EQ(render({}).exit_code, 0);
  const auto time = fs::last_write_time(path("p.01.exr"));
  ASSERT_EQ(render({"--video", "film.mp4"}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(path("p.01.exr")), time);
  EXPECT_TRUE(content("film.mp4") == pngs(0, 3));
  // A part of them, over the film that is there.
  ASSERT_EQ(render({"--video", "film.mp4", "--pictures", "1-2", "--quiet"}).exit_code, 0);
  EXPECT_TRUE(content("film.mp4") == pngs(1, 2));
  ASSERT_EQ(render({"--video", "one.mp4", "-p", "3", "-o", "single.exr"}).exit_code, 0);
  EXPECT_TRUE(content("one.mp4") == content("single.png"));
}

TEST_F(Video, TurnsPreviewsOn) {
  install(kRecorder);
  change_scene("path =", "preview = false\npath =");
  ASSERT_EQ(render({"-o", "q.##.exr"}).exit_code, 0);
  EXPECT_FALSE(exists("q.00.png"));
  const std::string before = content("q.02.exr");
  ASSERT_EQ(render({"-o", "q.##.exr", "--video", "q.mp4"}).exit_code, 0);
  EXPECT_TRUE(content("q.02.exr") == before);
  ASSERT_EQ(render({"--video", "film.mp4"}).exit_code, 0);
  EXPECT_TRUE(content("film.mp4") == pngs(0, 3));
  EXPECT_TRUE(content("q.mp4") == pngs(0, 3));
}

TEST_F(Video, WithoutFfmpegNothingIsRendered) {
  RunOptions options;
  for (const char* variable : {"", "/nowhere", ":"}) {
    options.path_variable = variable;
    expect_error(render({"--video", "film/x.mp4"}, options), 3, {"ffmpeg", "install"});
  }
  // A folder or a file that can not be run is no program.
  fs::create_directories(path("bin/ffmpeg"));
  expect_error(render({"--video", "film/x.mp4"}), 3, {"ffmpeg", "install"});
  fs::remove(path("bin/ffmpeg"));
  write("bin/ffmpeg", kRecorder);
  fs::permissions(path("bin/ffmpeg"), fs::perms::owner_read);
  expect_error(render({"--video", "film/x.mp4"}), 3, {"ffmpeg", "install"});
  EXPECT_FALSE(exists("p.00.exr"));
}

TEST_F(Video, WhatCanNotBeMadeIsSaidBeforeRendering) {
  install(kRecorder);
  expect_error(render({"--video", "film.avi"}), 2, {"\"film.avi\"", ".mp4"});
  write("file", "");
  expect_error(render({"--video", "file/film.mp4"}), 3, {"file/film.mp4"});
  expect_error(render({"--video", "/proc/film.mp4"}), 3, {"/proc/film.mp4"});
  change_scene("12.5", "4e-7");
  expect_error(render({"--video", "film.mp4"}), 2, {"animation.rate is 4e-07"});
  change_scene("path =", "layers = [\"Z\"]\npath =");
  expect_error(render({"--video", "film.mp4"}), 2, {"beauty"});
  EXPECT_FALSE(exists("p.00.exr"));
}

TEST_F(Video, AFailureShowsWhatFfmpegSaid) {
  for (const char* end : {"exit 1", "kill -9 $$", "exec /bin/cat > /dev/null"}) {
    install(std::string("#!/bin/sh\necho first >&2\necho no such encoder\n") + end + "\n");
    expect_error(render({"--video", "film/x.mp4"}), 3,
                 {"film/x.mp4: ffmpeg failed: first; no such encoder"});
    EXPECT_TRUE(fs::is_empty(path("film"))) << end;
  }
  install("#!/nowhere/sh\n");
  expect_error(render({"--video", "film/x.mp4"}), 3, {"bin/ffmpeg: can not be started"});
  EXPECT_TRUE(fs::is_empty(path("film")));
  EXPECT_TRUE(exists("p.03.exr"));
}

// More than a pipe holds, to one who does not take it all, or says more than a pipe holds.
TEST_F(Video, NeitherSideWaitsForEver) {
  const std::vector<std::string> large = {"--size", "900x700", "--video", "film/x.mp4"};
  install("#!/bin/sh\nfor last; do :; done\necho half > \"$last\"\nexit 0\n");
  expect_error(render(large), 3, {"ffmpeg failed"});
  EXPECT_TRUE(fs::is_empty(path("film")));
  install("#!/bin/sh\n/bin/head -c 300000 /dev/zero | /usr/bin/tr '\\0' y\nexit 1\n");
  const RunResult wordy = render(large);
  expect_error(wordy, 3, {"ffmpeg failed: yyy"});
  EXPECT_LT(wordy.error.size(), 1000U);
}

TEST_F(Video, SigtermEndsFfmpegToo) {
  install(
      "#!/bin/sh\necho $$ > process.txt\nfor last; do :; done\necho half > \"$last\"\n/bin/sleep "
      "60\n");
  ASSERT_EQ(render({}).exit_code, 0);
  write("film/x.mp4", "the film before");
  RunOptions options;
  options.timeout = std::chrono::milliseconds(1500);
  options.signal = SIGTERM;
  const RunResult result = render({"--video", "film/x.mp4"}, options);
  expect_error(result, 130, {"interrupted"});
  EXPECT_LT(result.duration.count(), 1500 + 3000);
  EXPECT_EQ(content("film/x.mp4"), "the film before");
  EXPECT_THAT(files_beside_film(), testing::ElementsAre("x.mp4"));
  const pid_t process = std::stoi(content("process.txt"));
  EXPECT_EQ(kill(process, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST_F(Video, RealFfmpegMakesAFilm) {
  const auto ffprobe = program_on_path("ffprobe");
  if (!program_on_path("ffmpeg") || !ffprobe) GTEST_SKIP() << "ffmpeg is not installed";
  RunOptions options;
  options.path_variable = std::getenv("PATH");
  const RunResult result = render({"--video", "film.mp4"}, options);
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const RunResult probe = run_program(
      *ffprobe, {"-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                 "stream=width,height,pix_fmt,r_frame_rate,nb_read_frames", "-of",
                 "default=noprint_wrappers=1", path("film.mp4").string()});
  for (const char* part : {"width=32\n", "height=26\n", "pix_fmt=yuv420p\n", "r_frame_rate=25/2\n",
                           "nb_read_frames=4\n"}) {
    EXPECT_THAT(probe.out, HasSubstr(part));
  }
}

}  // namespace
}  // namespace restframe

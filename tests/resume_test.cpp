// `restframe render` a second time: what counts as finished, what is made again, what is refused; and
// that a picture is the same whichever others are asked for with it.

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledRgbaFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <iterator>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kScene = R"(
[animation]
rate = 25
pictures = 4
[render]
resolution = [40, 30]
samples = 2
[output]
path = "p.#.exr"
layers = ["beauty", "time"]
[[object]]
asset = "square.obj"
velocity = [0.5, 0, 0]
)";

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

class Resume : public testing::Test {
 protected:
  Resume() {
    folder_.write("scene.toml", kScene);
    folder_.write("square.obj", kSquare);
  }

  RunResult render(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"render", "scene.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    RunOptions run_options;
    run_options.folder = folder_.path();
    return run_program(RESTFRAME_PROGRAM, arguments, run_options);
  }
  void make(const std::vector<std::string>& options = {}) const {
    const RunResult result = render(options);
    ASSERT_EQ(result.exit_code, 0) << result.error;
  }
  void expect_refused(const RunResult& result, const std::vector<std::string>& parts) const {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    for (const std::string& part : parts) EXPECT_THAT(result.error, HasSubstr(part));
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
  std::string content(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  bool exists(const std::string& name) const { return fs::exists(path(name)); }
  void change_scene(const std::string& before, const std::string& after) const {
    std::string text = kScene;
    write("scene.toml", text.replace(text.find(before), before.size(), after));
  }
  // What is there of p.1.exr in place of the whole is made again, and nothing else is.
  void expect_made_again(const std::string& damaged, const std::string& whole,
                         const std::string& what) const {
    ASSERT_NE(damaged, whole);
    write("p.1.exr", damaged);
    const RunResult result = render({"-p", "0-1"});
    EXPECT_EQ(result.exit_code, 0) << what << result.error;
    EXPECT_THAT(result.out, HasSubstr("1 of 2 pictures made")) << what;
    EXPECT_TRUE(content("p.1.exr") == whole) << what;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Resume, APictureThatIsCutAnywhereIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string whole = content("p.1.exr");
  for (std::size_t i = 0; i < 12; ++i) {
    const std::size_t left = i * whole.size() / 12;
    expect_made_again(whole.substr(0, left), whole, fmt::format("{} bytes were left", left));
  }
  expect_made_again(whole.substr(0, whole.size() - 1), whole, "all but one");
}

// Where the table of the picture's two blocks is: its first entry says where its own end is.
std::size_t block_table(const std::string& exr) {
  for (std::size_t at = 0; at + 16 <= exr.size(); ++at) {
    std::uint64_t first = 0;
    std::memcpy(&first, exr.data() + at, sizeof first);
    if (first == at + 16) return at;
  }
  throw std::runtime_error("no table");
}

std::string flipped(std::string bytes, std::size_t at) {
  bytes[at] = static_cast<char>(bytes[at] ^ 0x40);
  return bytes;
}

// In the table of blocks, in the first block's place and pixels, in the last one's.
TEST_F(Resume, APictureWhosePixelsAreDamagedIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string whole = content("p.1.exr");
  const std::size_t table = block_table(whole), first = table + 16;
  for (const std::size_t at : {table, table + 1, table + 7, table + 8, table + 12, first, first + 2,
                               first + 8, first + 30, whole.size() - 2, whole.size() - 1}) {
    expect_made_again(flipped(whole, at), whole, fmt::format("byte {} has changed", at));
  }
}

// What a machine leaves that lost its power.
TEST_F(Resume, APictureThatEndsInZerosIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string whole = content("p.1.exr");
  const std::size_t table = block_table(whole);
  std::vector<std::size_t> places = {table, table + 8, table + 16, table + 24, whole.size() - 4};
  for (std::size_t i = 1; i < 12; ++i) places.push_back(i * whole.size() / 12);
  for (const std::size_t at : places) {
    expect_made_again(whole.substr(0, at) + std::string(whole.size() - at, '\0'), whole,
                      fmt::format("zeros from {} on", at));
  }
}

// Somebody may have put work into it.
TEST_F(Resume, APictureThatWasChangedButIsWholeIsRefused) {
  make({"-p", "0-1"});
  const std::string whole = content("p.1.exr");
  const std::size_t text = whole.find("render.samples");
  ASSERT_LT(text, block_table(whole));
  for (const std::string& other : {flipped(whole, text), whole + '\0'}) {
    write("p.1.exr", other);
    expect_refused(render({"-p", "0-1"}),
                   {"p.1.exr: its bytes are not as restframe wrote them", "--overwrite"});
    EXPECT_TRUE(content("p.1.exr") == other);
  }
  make({"-p", "0-1", "--overwrite"});
  EXPECT_TRUE(content("p.1.exr") == whole);
}

TEST_F(Resume, PicturesOfOtherProgramsAreRefused) {
  const std::string name = path("p.1.exr").string();
  const Imath::Box2i window({-4, -2}, {35, 27});
  const Imf::Header header(window, window);
  const Imf::Array2D<Imf::Rgba> pixels(30, 40);
  const Imf::Rgba* origin = &pixels[2][4];
  const auto expect_kept = [&](const std::string& what) {
    const std::string before = content("p.1.exr");
    expect_refused(render({"-p", "0-1"}), {"p.1.exr: its bytes are not as restframe wrote them"});
    EXPECT_TRUE(content("p.1.exr") == before) << what;
  };
  const auto expect_lines_kept = [&](Imf::RgbaChannels channels, const std::string& what) {
    {
      Imf::RgbaOutputFile file(name.c_str(), header, channels);
      file.setFrameBuffer(origin, 1, 40);
      file.writePixels(30);
    }
    expect_kept(what);
  };
  expect_lines_kept(Imf::WRITE_RGBA, "lines");
  expect_lines_kept(Imf::WRITE_YCA, "colours for every other pixel");
  {
    Imf::TiledRgbaOutputFile file(name.c_str(), header, Imf::WRITE_RGBA, 16, 16, Imf::ONE_LEVEL);
    file.setFrameBuffer(origin, 1, 40);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  expect_kept("tiles");
}

TEST_F(Resume, APreviewThatIsNotWholeIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string exr = content("p.1.exr"), png = content("p.1.png");
  ASSERT_GT(png.size(), 60U);
  const auto expect_new_preview = [&](const std::string& what) {
    const RunResult result = render({"-p", "0-1"});
    EXPECT_THAT(result.out, HasSubstr("0 of 2 pictures made")) << what;
    EXPECT_TRUE(content("p.1.png") == png) << what;
    EXPECT_TRUE(content("p.1.exr") == exr) << what;
  };
  fs::remove(path("p.1.png"));
  expect_new_preview("no preview");
  for (const std::size_t left : {std::size_t{0}, std::size_t{7}, std::size_t{30}, png.size() - 1}) {
    write("p.1.png", png.substr(0, left));
    expect_new_preview(fmt::format("{} bytes of the preview", left));
  }
  write("p.1.png", png.substr(0, 40) + std::string(png.size() - 40, '\0'));
  expect_new_preview("zeros");
}

// From the picture, that is not rendered again, and as rendering it would have made it: half and float,
// in one file or several, of one eye or two, light apart from data.
TEST_F(Resume, APreviewIsDevelopedFromItsPicture) {
  const auto with = [](const std::string& keys) {
    std::string scene = kScene;
    return scene.replace(scene.find("layers ="), 0, keys);
  };
  for (const std::string& scene :
       {with(""), with("float = [\"beauty\"]\n"), with("split = true\n"),
        with("compression = \"pxr24\"\n"),
        kScene + std::string(
                     "[camera]\nposition = [0.5, 0.5, 3]\n[camera.stereo]\nseparation = 0.1\n")}) {
    write("scene.toml", scene);
    make({"-p", "0-1", "--overwrite"});
    const std::string plain = content("p.1.png");
    const std::vector<std::string> filmic = {"-p", "0-1", "--view", "filmic", "--exposure", "1"};
    EXPECT_THAT(render(filmic).out, HasSubstr("0 of 2 pictures made")) << scene;
    const std::string developed = content("p.1.png");
    EXPECT_FALSE(developed == plain) << scene;
    EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made")) << scene;
    EXPECT_TRUE(content("p.1.png") == plain) << scene;
    std::vector<std::string> again = filmic;
    again.emplace_back("--overwrite");
    make(again);
    EXPECT_TRUE(content("p.1.png") == developed) << scene;
  }
}

TEST_F(Resume, APreviewOfAnotherPictureIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string png = content("p.1.png");
  fs::copy_file(path("p.0.png"), path("p.1.png"), fs::copy_options::overwrite_existing);
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made"));
  EXPECT_TRUE(content("p.1.png") == png);
}

TEST_F(Resume, APictureOfWhichALayerIsMissingIsMadeAgain) {
  change_scene("[output]", "[output]\nsplit = true");
  make({"-p", "0-1"});
  const std::string whole = content("p.time.1.exr");
  fs::remove(path("p.time.1.exr"));
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("1 of 2 pictures made"));
  EXPECT_TRUE(content("p.time.1.exr") == whole);
  write("p.beauty.0.exr", "torn");
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("1 of 2 pictures made"));
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made"));
}

// As on a full disk: the preview is of the picture that is there already.
TEST_F(Resume, AFailedWriteLeavesWhatIsThere) {
  make({"-p", "0-1"});
  const std::string exr = content("p.0.exr"), png = content("p.0.png");
  ASSERT_LT(png.size(), exr.size());
  RunOptions options;
  options.folder = path("");
  options.largest_file = exr.size() - 1;
  const RunResult failed =
      run_program(RESTFRAME_PROGRAM, {"render", "scene.toml", "-p", "0-1", "--overwrite"}, options);
  EXPECT_EQ(failed.exit_code, 3) << failed.error;
  EXPECT_TRUE(content("p.0.exr") == exr);
  EXPECT_TRUE(content("p.0.png") == png);
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made"));
}

// Of a process that was killed between the two; of another picture; of another scene.
TEST_F(Resume, CheckpointsOfFinishedPicturesGo) {
  make({"-p", "1", "--tile", "1/1"});
  const std::string part = content("p.1.exr.part-01-of-1");
  make();
  fs::remove(path("p.1.exr.part-01-of-1"));
  make({"-p", "3", "--tile", "1/1", "--samples", "3", "-o", "q.#.exr"});
  fs::rename(path("q.3.exr.part-01-of-1"), path("p.3.exr.part"));
  write("p.1.exr.part", part);
  write("p.2.exr.part", part);
  EXPECT_THAT(render().out, HasSubstr("0 of 4 pictures made"));
  EXPECT_FALSE(exists("p.1.exr.part"));
  EXPECT_TRUE(exists("p.2.exr.part"));
  EXPECT_TRUE(exists("p.3.exr.part"));
}

TEST_F(Resume, NoPreviewIsMissedWhereNoneIsWanted) {
  change_scene("[output]", "[output]\npreview = false");
  make();
  EXPECT_FALSE(exists("p.1.png"));
  EXPECT_THAT(render().out, HasSubstr("0 of 4 pictures made"));
}

TEST_F(Resume, AChangedAssetIsNamed) {
  make();
  write("square.obj", std::string(kSquare) + "v 2 2 2\nf 1 2 5\n");
  expect_refused(render(), {"p.0.exr", "square.obj has changed", "--overwrite"});
}

TEST_F(Resume, AChangedSettingIsNamedWithBothValues) {
  make();
  change_scene("rate = 25", "rate = 24");
  expect_refused(render(), {"p.0.exr", "animation.rate was 25, is 24"});
}

TEST_F(Resume, WhatTheSceneFileSaysOtherwiseMakesNoDifference) {
  make();
  change_scene("rate = 25", "# as films in Europe\nrate = 25.0");
  EXPECT_THAT(render().out, HasSubstr("0 of 4 pictures made"));
}

TEST_F(Resume, AnAnimationMayGrow) {
  make();
  change_scene("pictures = 4", "pictures = 6");
  EXPECT_THAT(render().out, HasSubstr("2 of 6 pictures made, 4 were there already"));
}

TEST_F(Resume, AnotherPictureUnderTheNameIsRefused) {
  make({"-p", "1", "-o", "x.exr"});
  const std::string before = content("x.exr");
  expect_refused(render({"-p", "2", "-o", "x.exr"}), {"x.exr", "it is picture 1, not 2"});
  EXPECT_TRUE(content("x.exr") == before);
}

TEST_F(Resume, AnyChoiceOfPicturesGivesTheSameFiles) {
  make();
  std::vector<std::string> whole, previews;
  for (int i = 0; i < 4; ++i) {
    whole.push_back(content(fmt::format("p.{}.exr", i)));
    previews.push_back(content(fmt::format("p.{}.png", i)));
  }
  int folder = 0;
  for (const char* choice : {"2", "2-2", "1-3:2,2", "0-3:9,3-3:1,2,2"}) {
    const std::string name = fmt::format("{}/p.", folder++);
    make({"-p", choice, "-o", name + "#.exr"});
    EXPECT_TRUE(content(name + "2.exr") == whole[2]) << choice;
    EXPECT_TRUE(content(name + "2.png") == previews[2]) << choice;
  }
  EXPECT_FALSE(exists("0/p.0.exr") || exists("0/p.1.exr") || exists("2/p.0.exr"));
  EXPECT_TRUE(content("2/p.1.exr") == whole[1] && content("2/p.3.exr") == whole[3]);
  EXPECT_TRUE(exists("3/p.0.exr") && !exists("3/p.1.exr") && exists("3/p.3.exr"));
}

TEST_F(Resume, ChoicesThatAreNoneAreRefused) {
  for (const char* choice : {"", "-", "1-", "-1", "3-1", "0-3:0", "0-3:-1", "0-3:", "1:2", "1,",
                             ",1", "1,,2", "a", "0-3:1x", "0--3", "99999999999"}) {
    expect_refused(render({fmt::format("--pictures={}", choice)}), {"--pictures"});
  }
  expect_refused(render({"-p", "0-4"}), {"there is no picture 4; the last one is 3"});
  expect_refused(render({"-p", "0-2000000000:2000000000"}), {"there is no picture 2000000000"});
}

TEST_F(Resume, WhatKilledProcessesLeftGoes) {
  std::array<char, 65> host{};
  ASSERT_EQ(gethostname(host.data(), host.size() - 1), 0);
  std::string tag = host.data();
  std::replace_if(
      tag.begin(), tag.end(),
      [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  const std::string here = ".restframe-" + tag.substr(0, 32) + "-";
  write(here + "1-0.tmp", "half");
  write(here + "1-1.tmp", "half, and somebody is at it");
  write(".restframe-elsewhere-1-0.tmp", "half, perhaps with somebody at it");
  write(".restframe-elsewhere-1-1.tmp", "half");
  write("restframe.tmp", "something else");
  fs::last_write_time(path(".restframe-elsewhere-1-1.tmp"),
                      fs::file_time_type::clock::now() - std::chrono::hours(2));
  const int at_work = open(path(here + "1-1.tmp").c_str(), O_RDWR);
  ASSERT_EQ(flock(at_work, LOCK_EX), 0);
  make();
  close(at_work);
  EXPECT_FALSE(exists(here + "1-0.tmp"));
  EXPECT_TRUE(exists(here + "1-1.tmp"));
  EXPECT_TRUE(exists(".restframe-elsewhere-1-0.tmp"));
  EXPECT_FALSE(exists(".restframe-elsewhere-1-1.tmp"));
  EXPECT_TRUE(exists("restframe.tmp"));
  write(here + "1-0.tmp", "half");
  EXPECT_THAT(render().out, HasSubstr("0 of 4 pictures made"));
  EXPECT_FALSE(exists(here + "1-0.tmp"));
}

}  // namespace
}  // namespace restframe

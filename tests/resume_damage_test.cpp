// `restframe render` a second time, after something went wrong: what is torn or damaged is made again, what
// somebody else may have made is refused, and what killed processes left is cleared up.

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

#include "support/program_errors.h"
#include "support/resumed_animation.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ResumeAfterDamage : public ResumedAnimation {
 protected:
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
};

TEST_F(ResumeAfterDamage, APictureThatIsCutAnywhereIsMadeAgain) {
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
TEST_F(ResumeAfterDamage, APictureWhosePixelsAreDamagedIsMadeAgain) {
  make({"-p", "0-1"});
  const std::string whole = content("p.1.exr");
  const std::size_t table = block_table(whole), first = table + 16;
  for (const std::size_t at : {table, table + 1, table + 7, table + 8, table + 12, first, first + 2,
                               first + 8, first + 30, whole.size() - 2, whole.size() - 1}) {
    expect_made_again(flipped(whole, at), whole, fmt::format("byte {} has changed", at));
  }
}

// What a machine leaves that lost its power.
TEST_F(ResumeAfterDamage, APictureThatEndsInZerosIsMadeAgain) {
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
TEST_F(ResumeAfterDamage, APictureThatWasChangedButIsWholeIsRefused) {
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

TEST_F(ResumeAfterDamage, PicturesOfOtherProgramsAreRefused) {
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

TEST_F(ResumeAfterDamage, APictureOfWhichALayerIsMissingIsMadeAgain) {
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
TEST_F(ResumeAfterDamage, AFailedWriteLeavesWhatIsThere) {
  make({"-p", "0-1"});
  const std::string exr = content("p.0.exr"), png = content("p.0.png");
  ASSERT_LT(png.size(), exr.size());
  RunOptions options;
  options.largest_file = exr.size() - 1;
  const RunResult failed = render({"-p", "0-1", "--overwrite"}, options);
  EXPECT_EQ(failed.exit_code, 3) << failed.error;
  EXPECT_TRUE(content("p.0.exr") == exr);
  EXPECT_TRUE(content("p.0.png") == png);
  EXPECT_THAT(render({"-p", "0-1"}).out, HasSubstr("0 of 2 pictures made"));
}

// Of a process that was killed between the two; of another picture; of another scene.
TEST_F(ResumeAfterDamage, CheckpointsOfFinishedPicturesGo) {
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

TEST_F(ResumeAfterDamage, WhatKilledProcessesLeftGoes) {
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

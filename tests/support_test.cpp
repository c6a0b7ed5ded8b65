#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>
#include <gtest/gtest.h>

#include "support/exr_reader.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

void write_example(const std::filesystem::path& file) {
  const Imath::Box2i window({-1, 2}, {1, 3});  // 3 wide, 2 high
  Imf::Header header(window, window);
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.insert("note", Imf::StringAttribute("gamma"));
  header.insert("exact", Imf::DoubleAttribute(0.1));
  header.insert("axis", Imf::V3fAttribute({1, -0.5F, 0}));
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  header.channels().insert("id.V", Imf::Channel(Imf::UINT));
  std::vector<float> z = {1, 2, 3, 4, 5, 1e30F};
  std::vector<unsigned> id = {0, 1, 2, 3, 4, 100};
  Imf::FrameBuffer buffer;
  buffer.insert("Z", Imf::Slice::Make(Imf::FLOAT, z.data(), window, 4, 12));
  buffer.insert("id.V", Imf::Slice::Make(Imf::UINT, id.data(), window, 4, 12));
  Imf::OutputFile output(file.c_str(), header);
  output.setFrameBuffer(buffer);
  output.writePixels(2);
}

TEST(ReadExr, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  write_example(folder.path() / "a.exr");
  const ExrPicture picture = read_exr(folder.path() / "a.exr");
  EXPECT_EQ(picture.width, 3);
  EXPECT_EQ(picture.height, 2);
  EXPECT_EQ(picture.channels.size(), 2U);
  EXPECT_EQ(picture.at("Z", 0, 0), 1);
  EXPECT_EQ(picture.at("Z", 2, 1), 1e30F);
  EXPECT_EQ(picture.at("id.V", 0, 1), 3);
  EXPECT_EQ(picture.attributes.at("note"), "gamma");
  EXPECT_EQ(picture.attributes.at("exact"), "0.1");
  EXPECT_EQ(picture.attributes.at("axis"), "1 -0.5 0");
  EXPECT_EQ(picture.attributes.at("compression"), "zips");
  EXPECT_EQ(picture.attributes.at("dataWindow"), "-1 2 1 3");
  EXPECT_THROW(picture.channel("R"), std::runtime_error);
}

TEST(ReadExr, RefusesWhatIsNoWholePicture) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_exr(folder.path() / "none.exr"), std::runtime_error);
  EXPECT_THROW(read_exr(folder.write("text.exr", "no picture")), std::runtime_error);
  write_example(folder.path() / "a.exr");
  std::filesystem::resize_file(folder.path() / "a.exr",
                               std::filesystem::file_size(folder.path() / "a.exr") - 8);
  EXPECT_THROW(read_exr(folder.path() / "a.exr"), std::runtime_error);
}

TEST(RunProgram, CapturesStreamsAndExitCode) {
  const RunResult result =
      run_program("/bin/sh", {"-c", "echo \"$0 $1\"; echo bad >&2; cat; exit 3", "a b", "*"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_FALSE(result.signal);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.out, "a b *\n");
  EXPECT_EQ(result.error, "bad\n");
}

TEST(RunProgram, TakesMoreThanAPipeHolds) {
  const RunResult result = run_program("/bin/sh", {"-c", "head -c 1000000 /dev/zero"});
  EXPECT_EQ(result.out.size(), 1000000U);
}

TEST(RunProgram, ReportsSignalsAndTimeouts) {
  EXPECT_EQ(run_program("/bin/sh", {"-c", "kill -SEGV $$"}).signal, SIGSEGV);
  const RunResult late =
      run_program("/bin/sleep", {"30"}, {.timeout = std::chrono::milliseconds(50)});
  EXPECT_TRUE(late.timed_out);
  EXPECT_EQ(late.signal, SIGKILL);
  const RunResult asked =
      run_program("/bin/sh", {"-c", "trap 'exit 130' TERM; while :; do sleep 0.01; done"},
                  {.timeout = std::chrono::milliseconds(200), .signal = SIGTERM});
  EXPECT_TRUE(asked.timed_out);
  EXPECT_EQ(asked.exit_code, 130);
}

TEST(RunProgram, RunsInAFolderWithinLimits) {
  const TemporaryFolder folder;
  RunOptions options;
  options.folder = folder.path();
  options.largest_file = 1000;
  const RunResult result =
      run_program("/bin/sh", {"-c", "pwd -P; head -c 2000 /dev/zero > big"}, options);
  EXPECT_EQ(result.out, std::filesystem::canonical(folder.path()).string() + "\n");
  EXPECT_NE(result.exit_code, 0);
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "big"), 1000U);
  EXPECT_EQ(run_program(folder.path() / "nothing", {}).exit_code, 127);
}

TEST(TemporaryFolder, IsUniqueAndGoes) {
  std::filesystem::path gone;
  {
    const TemporaryFolder a, b;
    EXPECT_NE(a.path(), b.path());
    gone = a.write("sub/file.txt", "x");
    EXPECT_TRUE(std::filesystem::exists(gone));
  }
  EXPECT_FALSE(std::filesystem::exists(gone));
}

}  // namespace
}  // namespace restframe

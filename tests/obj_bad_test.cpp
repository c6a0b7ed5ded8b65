#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>

#include "importers/importers.h"
#include "scene/error.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using testing::HasSubstr;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

class BadObj : public testing::Test {
 protected:
  // What is wrong with the file, after its name; empty if nothing is.
  std::string fault_of(const std::string& text, const ImportLimits& limits = {}) {
    return fault_at(files_.write("bad.obj", text), limits);
  }

  std::string fault_at(const Path& path, const ImportLimits& limits = {}) {
    Warnings warnings;
    try {
      load_obj(path, limits, warnings);
      return "";
    } catch (const InputError& error) {
      const std::string message = error.what(), name = path.string();
      EXPECT_EQ(message.find('\n'), message.npos);
      EXPECT_EQ(message.substr(0, name.size()), name);
      return message.substr(name.size());
    }
  }

  TemporaryFolder files_;
};

TEST_F(BadObj, Indices) {
  EXPECT_EQ(fault_of(triangle + "f 0 1 2\n"), ":4:3: v index 0: the first is 1");
  EXPECT_EQ(fault_of(triangle + "f 1 2 4\n"), ":4:7: v index 4: there are only 3 v lines");
  EXPECT_EQ(fault_of(triangle + "f -1 -2 -4\n"), ":4:9: v index -4: only 3 v lines come before it");
  EXPECT_EQ(fault_of(triangle + "vt 0 0\nf 1/1 2/0 3/1\n"), ":5:9: vt index 0: the first is 1");
  EXPECT_EQ(fault_of(triangle + "f 1/1 2/1 3/1\n"), ":4:5: vt index 1: there are only 0 vt lines");
  EXPECT_EQ(fault_of(triangle + "vn 0 0 1\nf 1//1 2//1 3//0\n"),
            ":5:16: vn index 0: the first is 1");
  EXPECT_EQ(fault_of(triangle + "vn 0 0 1\nf 1//1 2//-2 3//1\n"),
            ":5:11: vn index -2: only 1 vn lines come before it");
  EXPECT_THAT(fault_of(triangle + "f 1 2 99999999999999999999\n"), HasSubstr(":4:7: v index 9"));
  EXPECT_THAT(fault_of(triangle + "f 1 2 -99999999999999999999\n"), HasSubstr(":4:7: v index -9"));
  EXPECT_THAT(fault_of(triangle + "f 1 2 4294967299\n"), HasSubstr(":4:7: v index 4294967299"));
}

TEST_F(BadObj, Faces) {
  EXPECT_EQ(fault_of(triangle + "f a//1 2 3\n"), ":4:3: \"a\" is not a v index");
  EXPECT_EQ(fault_of(triangle + "f /1 2 3\n"), ":4:3: \"/1\" has no vertex index");
  EXPECT_EQ(fault_of(triangle + "f 1 2\n"), ":4:1: a face of 2 corners, must be at least 3");
  EXPECT_EQ(fault_of(triangle + "f\n"), ":4:1: a face of 0 corners, must be at least 3");
  EXPECT_EQ(fault_of(triangle + "f 1 2 # 3\n"), ":4:1: a face of 2 corners, must be at least 3");
  EXPECT_EQ(fault_of(triangle + "f 1 2 3.0\n"), ":4:7: \"3.0\" is not a v index");
  EXPECT_THAT(fault_of(triangle + "f 1////1 2 3\n"), HasSubstr(":4:3: \"1////1\" must be v,"));
}

TEST_F(BadObj, PositionsCountContinuedLines) {
  EXPECT_EQ(fault_of(triangle + "f 1 \\\r\n2 \\\r\n  x\n"), ":6:3: \"x\" is not a v index");
}

TEST_F(BadObj, Numbers) {
  EXPECT_EQ(fault_of("v 0 nan 0\n"), ":1:5: \"nan\" is not a finite number");
  EXPECT_EQ(fault_of("v 0 0 -inf\n"), ":1:7: \"-inf\" is not a finite number");
  EXPECT_EQ(fault_of("v 0 1e400 0\n"), ":1:5: \"1e400\" is not a finite number");
  EXPECT_EQ(fault_of("v 0 2e15 0\n"), ":1:5: \"2e15\" is beyond the limit of 1e15");
  EXPECT_EQ(fault_of("\n v 0 0\n"),
            ":2:1: v with 2 numbers: must be 3, or 4, 6 or 7 with weight or colour");
  EXPECT_THAT(fault_of("v 0,5 0 0\n"), HasSubstr(":1:3: \"0,5\" is not a number: write decimals"));
  EXPECT_THAT(fault_of("v 0 0 0x10\n"), HasSubstr(":1:7:"));
  EXPECT_THAT(fault_of("v 1 2 3.1+e2\n"), HasSubstr(":1:7:"));
  EXPECT_THAT(fault_of("v 1 2 +-3\n"), HasSubstr(":1:7:"));
  EXPECT_EQ(fault_of(triangle + "vn 0 1\n"), ":4:1: vn with 2 numbers, must be 3");
  EXPECT_EQ(fault_of(triangle + "vt\n"), ":4:1: vt with 0 numbers, must be 1 to 3");
  EXPECT_THAT(fault_of("v 1e99999999999 0 0\n"), HasSubstr(":1:3:"));
  EXPECT_THAT(fault_of("v 0x1 0 0\n"), HasSubstr(":1:3:"));
  EXPECT_THAT(fault_of("v 1e+ 0 0\n"), HasSubstr(":1:3:"));
  EXPECT_THAT(fault_of("v - 0 0\n"), HasSubstr(":1:3:"));
  EXPECT_EQ(fault_of("v 1e-99999999999 0 -0\nv 1E+2 0 0\nv 0 1 0\nf 1 2 3\n"), "");
  EXPECT_EQ(fault_of("v 1e-400 0 0\nv 1 0 1e-40\nv 0 1 0\nf 1 2 3\n"), "");
}

TEST_F(BadObj, Encodings) {
  using namespace std::string_literals;
  EXPECT_THAT(fault_of("\xFF\xFEv\0 \0"s), HasSubstr(":1:1: the text is UTF-16"));
  EXPECT_THAT(fault_of("\xFE\xFF\0v\0 "s), HasSubstr(":1:1: the text is UTF-16"));
  EXPECT_THAT(fault_of("v\0 \0001\0"s), HasSubstr(":1:1: the text is UTF-16"));
  EXPECT_THAT(fault_of(triangle + "f 1 \0 2 3\n"s), HasSubstr(":4:5: a NUL byte"));
}

TEST_F(BadObj, NothingToRender) {
  EXPECT_EQ(fault_of(""), ": nothing to render: no faces");
  EXPECT_EQ(fault_of(triangle + "p 1 2 3\nl 1 2\n"), ": nothing to render: no faces");
  Warnings warnings;
  EXPECT_THROW(load_obj(files_.path() / "bad.obj", {}, warnings), InputError);
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("points are not renderable")));
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("lines are not renderable")));
}

TEST_F(BadObj, Limits) {
  ImportLimits limits;
  limits.triangles = 2;
  EXPECT_EQ(fault_of(triangle + "f 1 2 3\nf 1 2 3\n", limits), "");
  EXPECT_EQ(fault_of(triangle + "f 1 2 3\nf 1 2 3 1\n", limits),
            ":5:1: more than 2 triangles, the limit");
  limits = {};
  limits.total_bytes = 20;
  EXPECT_THAT(fault_of(triangle + "f 1 2 3\n", limits), HasSubstr("bytes"));
  limits.total_bytes = 70;
  EXPECT_THAT(fault_of(triangle + "f 1 2 3\n", limits), HasSubstr("needs more than 70 bytes"));
  limits = {};
  limits.nodes = 1;
  EXPECT_THAT(fault_of(triangle + "f 1 2 3\ng a\nf 1 2 3\n", limits), HasSubstr("2 groups"));
}

TEST_F(BadObj, NotARegularFile) {
  EXPECT_THAT(fault_at(files_.path() / "missing.obj"), HasSubstr(": no such file"));
  std::filesystem::create_directory(files_.path() / "folder.obj");
  EXPECT_EQ(fault_at(files_.path() / "folder.obj"), ": is a folder, not a regular file");
  ASSERT_EQ(mkfifo((files_.path() / "fifo.obj").c_str(), 0600), 0);
  EXPECT_EQ(fault_at(files_.path() / "fifo.obj"), ": is not a regular file");
}

TEST_F(BadObj, MaterialFilesStayInTheFolder) {
  const std::string face = triangle + "f 1 2 3\n";
  const TemporaryFolder elsewhere;
  elsewhere.write("m.mtl", "newmtl a\n");
  std::filesystem::create_symlink(elsewhere.path() / "m.mtl", files_.path() / "link.mtl");
  std::filesystem::create_directory_symlink(elsewhere.path(), files_.path() / "linked");
  std::filesystem::create_directory(files_.path() / "sub");
  const std::string other = elsewhere.path().filename().string();
  for (const std::string& name :
       {"../" + other + "/m.mtl", std::string("../nothing.mtl"), "sub/../../" + other + "/m.mtl",
        "..\\" + other + "\\m.mtl", std::string("link.mtl"), std::string("linked/m.mtl")}) {
    EXPECT_THAT(fault_of("mtllib " + name + "\n" + face),
                testing::AllOf(HasSubstr(":1:8: "), HasSubstr("leads out of the asset's folder")));
  }
  for (const std::string& name : {(elsewhere.path() / "m.mtl").string(), std::string("/dev/zero"),
                                  std::string("C:\\m.mtl"), std::string("\\m.mtl")}) {
    EXPECT_THAT(fault_of("mtllib " + name + "\n" + face), HasSubstr("is an absolute path"));
  }
}

TEST_F(BadObj, MaterialFilesAreRegularFiles) {
  const std::string face = triangle + "f 1 2 3\n";
  std::filesystem::create_directory(files_.path() / "folder.mtl");
  ASSERT_EQ(mkfifo((files_.path() / "fifo.mtl").c_str(), 0600), 0);
  EXPECT_THAT(fault_of("mtllib folder.mtl\n" + face), HasSubstr("is not a regular file"));
  EXPECT_THAT(fault_of("mtllib fifo.mtl\n" + face), HasSubstr("is not a regular file"));
  std::string many = face;
  for (int i = 0; i < 1001; ++i) many += fmt::format("mtllib {}.mtl\n", i);
  EXPECT_THAT(fault_of(many), HasSubstr(":1005:1: more than 1000 mtllib statements"));
  EXPECT_THAT(fault_of("mtllib\n" + face), HasSubstr(":1:1: mtllib without a file name"));
}

TEST_F(BadObj, MaterialsAndTextures) {
  const std::string text = "mtllib m.mtl\nusemtl a\n" + triangle + "f 1 2 3\n";
  const auto fault_with = [&](const std::string& mtl) {
    files_.write("m.mtl", "newmtl a\n" + mtl);
    const Path path = files_.write("bad.obj", text);
    Warnings warnings;
    try {
      load_obj(path, {}, warnings);
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(fault_with("Kd 1 1 1\n"), "");
  EXPECT_THAT(fault_with("Kd 1 nan 1\n"), HasSubstr("m.mtl:2:6: \"nan\" is not a finite number"));
  EXPECT_THAT(fault_with("Kd 1 1\n"), HasSubstr("m.mtl:2:1: Kd without a number"));
  EXPECT_THAT(fault_with("d\n"), HasSubstr("m.mtl:2:1: d without a number"));
  EXPECT_THAT(fault_with("Ns 0,5\n"), HasSubstr("m.mtl:2:4: \"0,5\" is not a number"));
  EXPECT_THAT(fault_with("map_Kd ../x.png\n"), HasSubstr("leads out of the asset's folder"));
  EXPECT_THAT(fault_with("map_Kd /dev/zero\n"), HasSubstr("is an absolute path"));
  files_.write("broken.png", "\x89PNG\r\n\x1a\n");
  EXPECT_THAT(fault_with("map_Kd broken.png\n"), HasSubstr("broken.png"));
}

// Texts made to be slow: each would take minutes if something grew with a square.
TEST_F(BadObj, NothingTakesLong) {
  const auto start = std::chrono::steady_clock::now();
  std::string returns = triangle, many_uvs = triangle, groups = triangle,
              joints = triangle + "f 1 2";
  for (int i = 0; i < 100'000; ++i) {
    returns += "#\r";
    many_uvs += fmt::format("vt 0 0\nf 1/{0} 2/{0} 3/{0}\n", i + 1);
    groups += fmt::format("g {0}\nusemtl {0}\nf 1 2 3\n", i + 1);
    joints += " \\\n";
  }
  EXPECT_EQ(fault_of(returns + "f 1 2 3"), "");
  EXPECT_EQ(fault_of(many_uvs), "");
  EXPECT_EQ(fault_of(groups), "");
  EXPECT_EQ(fault_of(joints + "3"), "");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace restframe

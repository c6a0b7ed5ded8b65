// OBJ files of strangers: a bad line is named by its number, never skipped.

#include <sys/stat.h>

#include "support/hostile.h"

namespace restframe {
namespace {

using test::Hostile;

class HostileObj : public Hostile {
 protected:
  void expect_text_refused(const std::string& text, const std::string& begin,
                           const std::string& part = "") const {
    SCOPED_TRACE(text.substr(0, 80));
    folder.write("a.obj", text);
    expect_refused("a.obj", begin, part);
  }

  std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::string face = triangle + "f 1 2 3\n";
};

TEST_F(HostileObj, IndicesOutOfRange) {
  const std::string more = triangle + "vt 0 0\nvn 0 0 1\n";
  expect_text_refused(more + "f 0 1 2\n", "6:3: v index 0: the first is 1");
  expect_text_refused(more + "f 1 2 4\n", "6:7: v index 4: there are only 3 v lines");
  expect_text_refused(more + "f -1 -2 -4\n", "6:9: v index -4: only 3 v lines come before it");
  expect_text_refused(more + "f 1/1 2/0 3/1\n", "6:9: vt index 0: the first is 1");
  expect_text_refused(more + "f 1/1 2/2 3/1\n", "6:9: vt index 2: there are only 1 vt lines");
  expect_text_refused(more + "f 1/1 2/-2 3/1\n", "6:9: vt index -2: only 1 vt lines");
  expect_text_refused(more + "f 1//1 2//1 3//0\n", "6:16: vn index 0: the first is 1");
  expect_text_refused(more + "f 1//1 2//7 3//1\n", "6:11: vn index 7: there are only 1 vn lines");
  expect_text_refused(more + "f 1//1 2//-2 3//1\n", "6:11: vn index -2: only 1 vn lines");
  expect_text_refused(more + "f 1 2 99999999999999999999\n", "6:7: v index 9");
}

TEST_F(HostileObj, FacesThatAreNone) {
  expect_text_refused(triangle + "f a//1 2 3\n", "4:3: \"a\" is not a v index");
  expect_text_refused(triangle + "f /1 2 3\n", "4:3: \"/1\" has no vertex index");
  expect_text_refused(triangle + "f 1 2\n", "4:1: a face of 2 corners, must be at least 3");
}

TEST_F(HostileObj, NumbersThatAreNone) {
  expect_text_refused("v 0 nan 0\n" + face, "1:5: \"nan\" is not a finite number");
  expect_text_refused("v 0 inf 0\n" + face, "1:5: \"inf\" is not a finite number");
  expect_text_refused("\nv 0 0\n" + face, "2:1: v with 2 numbers");
  expect_text_refused("v 0,5 0 0\n" + face, "1:3: \"0,5\" is not a number: write decimals");
  expect_text_refused("v 0 2e15 0\n" + face, "1:5: \"2e15\" is beyond the limit of 1e15");
}

TEST_F(HostileObj, Encodings) {
  using namespace std::string_literals;
  expect_text_refused("\xFF\xFEv\0 \0"s, "1:1: the text is UTF-16");
  expect_text_refused("\xFE\xFF\0v\0 "s, "1:1: the text is UTF-16");
  expect_text_refused(triangle + "f 1 \0 2 3\n"s, "4:5: a NUL byte");
}

TEST_F(HostileObj, MaterialLibrariesOutsideTheFolder) {
  folder.write("m.mtl", "newmtl a\n");
  folder.write("in/x", "");
  std::filesystem::create_symlink("../m.mtl", folder.path() / "in/link.mtl");
  ASSERT_EQ(::mkfifo((folder.path() / "in/fifo.mtl").c_str(), 0600), 0);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"../m.mtl", "leads out of the asset's folder"},
      {"x/../../m.mtl", "leads out of the asset's folder"},
      {"..\\m.mtl", "leads out of the asset's folder"},
      {"link.mtl", "leads out of the asset's folder"},
      {(folder.path() / "m.mtl").string(), "is an absolute path"},
      {"/dev/zero", "is an absolute path"},
      {"C:\\m.mtl", "is an absolute path"},
      {"fifo.mtl", "is not a regular file"}};
  for (const auto& [name, part] : cases) {
    folder.write("in/a.obj", "mtllib " + name + "\n" + face);
    expect_refused("in/a.obj", "1:8: ", part);
  }
}

TEST_F(HostileObj, WhatWorks) {
  folder.write("crlf.obj", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n");
  folder.write("continued.obj", triangle + "f 1 \\\n 2 \\\r\n 3\n");
  folder.write("negative.obj", triangle + "f -3 -2 -1\n");
  for (const char* name : {"crlf.obj", "continued.obj", "negative.obj"}) expect_rendered(name);
}

}  // namespace
}  // namespace restframe

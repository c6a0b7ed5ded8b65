// What an asset of a stranger names: only regular files of its own folder are opened.

#include <sys/stat.h>

#include "support/hostile_gltf.h"

namespace restframe {
namespace {

using test::HostileGltf;

class HostileUri : public HostileGltf {
 protected:
  HostileUri() {
    const std::string bin = test::one_triangle().bin;
    folder.write("outside.bin", bin);
    folder.write("in/inside.bin", bin);
    std::filesystem::create_directories(folder.path() / "in/folder");
  }

  void write_asset(const std::string& uri) const {
    folder.write("in/a.gltf", test::one_triangle().gltf(uri));
  }

  void expect_uri_refused(const std::string& uri, const std::string& part) const {
    SCOPED_TRACE(uri.substr(0, 80));
    write_asset(uri);
    expect_refused("in/a.gltf", "/buffers/0", part);
  }
};

TEST_F(HostileUri, LeavingTheFolderInAnySpelling) {
  for (const char* uri :
       {"../outside.bin", "..%2foutside.bin", "..%2Foutside.bin", "%2e%2e/outside.bin",
        "%2e%2e%2foutside.bin", "x/../../outside.bin", "./%2E./outside.bin",
        "folder/../../in/../"
        "outside.bin"}) {
    expect_uri_refused(uri, "leads out of the asset's folder");
  }
  expect_uri_refused((folder.path() / "in/inside.bin").string(), "is an absolute path");
  expect_uri_refused("%2fetc%2fpasswd", "is an absolute path");
  expect_uri_refused("C:\\a.bin", "backslash in URI");
  expect_uri_refused("C:/a.bin", "is neither a relative path nor data:");
  std::filesystem::create_symlink("../outside.bin", folder.path() / "in/link.bin");
  std::filesystem::create_directory_symlink("..", folder.path() / "in/up");
  expect_uri_refused("link.bin", "leads out of the asset's folder");
  expect_uri_refused("up/outside.bin", "leads out of the asset's folder");
}

TEST_F(HostileUri, OtherSchemes) {
  for (const char* uri : {"http://example.com/a.bin", "https://example.com/a.bin",
                          "file:inside.bin", "file:///etc/passwd", "FTP://x/y", "javascript:0"}) {
    expect_uri_refused(uri, "is neither a relative path nor data:");
  }
}

TEST_F(HostileUri, WhatIsNoRegularFile) {
  ASSERT_EQ(::mkfifo((folder.path() / "in/fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "in/zero");
  expect_uri_refused("folder", "not a regular file");
  expect_uri_refused("fifo", "not a regular file");
  expect_uri_refused("zero", "leads out of the asset's folder");
  expect_uri_refused("/dev/zero", "is an absolute path");
}

TEST_F(HostileUri, NamesThatAreNone) {
  expect_uri_refused("", "URI is empty");
  expect_uri_refused("inside.bin%00.png", "NUL in URI");
  expect_uri_refused("inside%zz.bin", "malformed %");
  expect_uri_refused("missing.bin", "can not find file \"missing.bin\"");
  expect_uri_refused(std::string(100'000, 'a'), "can not find file \"aaa");
}

TEST_F(HostileUri, PresentInTheCurrentFolderOnly) {
  expect_uri_refused("outside.bin", "can not find file \"outside.bin\"");
}

TEST_F(HostileUri, SizesThatDiffer) {
  const std::string bin = test::one_triangle().bin;
  folder.write("in/short.bin", bin.substr(1));
  folder.write("in/long.bin", bin + "x");
  expect_uri_refused("short.bin", ": byteLength is 42, but there are 41 bytes");
  expect_uri_refused("long.bin", ": byteLength is 42, but there are 43 bytes");
  expect_set("/buffers", {{{"byteLength", 0}}}, "/buffers/0/byteLength: is 0");
  expect_set("/buffers", {{{"byteLength", 1000}}},
             "/buffers/0: byteLength is 1000, but there are 44");
}

TEST_F(HostileUri, Base64) {
  const std::string data = "data:application/octet-stream;base64,";
  for (const char* text : {"A", "AAA*", "AA=A", "====", "AAAA\n", "\xc3\xa9"}) {
    expect_uri_refused(data + text, "malformed base64");
  }
  expect_uri_refused(data + "AAAA", "byteLength is 42, but there are 3 bytes");
  expect_uri_refused("data:,hello", "is not ;base64,");
  // Huge: longer than the JSON may be.
  write_asset(data + std::string(65'000'000, 'A'));
  expect_refused("in/a.gltf", " JSON of 65", "the limit is 64000000 bytes");
  expect_refused("in/a.gltf", "", "the limit is 3000 bytes", {"--max-bytes", "3000"});
}

}  // namespace
}  // namespace restframe

#include "scene/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "scene/error.h"
#include "support/file_bytes.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

void write_text(const fs::path& path, std::string_view text) {
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

std::string failure_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const OutputError& error) {
    return error.what();
  }
  return "";
}

TEST(AtomicFile, WritesBytesAndReplacesWhatWasThere) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.bin";
  write_text(path, "first");
  write_text(path, std::string_view("\0\xff\n", 3));
  EXPECT_EQ(bytes_of(path), std::string("\0\xff\n", 3));
  EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("a.bin"));
}

TEST(AtomicFile, CreatesMissingFolders) {
  const TemporaryFolder folder;
  write_text(folder.path() / "b" / "c" / "a.txt", "x");
  EXPECT_EQ(bytes_of(folder.path() / "b" / "c" / "a.txt"), "x");
}

TEST(AtomicFile, WritesPiecesOfAnySizeInOrder) {
  const TemporaryFolder folder;
  std::string expected;
  write_file_atomically(folder.path() / "a", [&](AtomicFile& file) {
    for (std::size_t i = 0; i < 40; ++i) {
      const std::string piece(i * i * i * 3, static_cast<char>('a' + i % 26));
      file.write(piece);
      expected += piece;
    }
  });
  EXPECT_EQ(bytes_of(folder.path() / "a"), expected);
}

TEST(AtomicFile, IsNotThereBeforeItIsWhole) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  write_text(path, "old");
  write_file_atomically(path, [&](AtomicFile& file) {
    file.write(std::string(1'000'000, 'x'));
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_EQ(names_in(folder.path()).size(), 2U);
  });
  EXPECT_EQ(bytes_of(path).size(), 1'000'000U);
}

TEST(AtomicFile, KeepsNothingOfAProducerThatThrows) {
  const TemporaryFolder folder;
  const auto produce = [](AtomicFile& file) {
    file.write(std::string(1'000'000, 'x'));
    throw Interrupted();
  };
  EXPECT_THROW(write_file_atomically(folder.path() / "a", produce), Interrupted);
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
}

TEST(AtomicFile, LeavesADeviceAlone) {
  const TemporaryFolder folder;
  const fs::path link = folder.path() / "full.glb";
  fs::create_symlink("/dev/full", link);
  for (const fs::path& path : {link, fs::path("/dev/full")}) {
    EXPECT_THAT(failure_of([&] { write_text(path, "x"); }),
                AllOf(HasSubstr("/dev/full"), HasSubstr("not a regular file")));
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("full.glb"));
}

TEST(AtomicFile, FollowsALinkToAFile) {
  const TemporaryFolder folder;
  write_text(folder.path() / "real" / "a", "old");
  fs::create_symlink("real/a", folder.path() / "link");
  write_text(folder.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(bytes_of(folder.path() / "real" / "a"), "new");
}

TEST(AtomicFile, SaysWhyAPathCanNotBeWritten) {
  const TemporaryFolder folder;
  write_text(folder.path() / "file", "x");
  fs::create_directory(folder.path() / "folder");
  const auto failure = [&](const fs::path& path) {
    return failure_of([&] { write_text(folder.path() / path, "y"); });
  };
  EXPECT_THAT(failure("file/below"), AllOf(HasSubstr("file/below"), HasSubstr("Not a directory")));
  EXPECT_THAT(failure("folder"), HasSubstr("not a regular file"));
  EXPECT_THAT(failure("folder/"), HasSubstr("names no file"));
  EXPECT_THAT(failure(std::string(300, 'n')), HasSubstr("File name too long"));
  EXPECT_THAT(failure(std::string("a\0b", 3)), HasSubstr("NUL"));
  EXPECT_EQ(names_in(folder.path()).size(), 2U);
}

TEST(AtomicFile, SaysThatAFolderIsReadOnly) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(failure_of([&] { write_text(folder.path() / "a", "x"); }),
              HasSubstr("Permission denied"));
  fs::permissions(folder.path(), fs::perms::owner_all);
}

// No file of this process may grow beyond `bytes` while it exists: as if the disk were full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(AtomicFile, LeavesNothingPartialWhenThereIsNoRoom) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  write_text(path, "old");
  std::string failure;
  for (const std::size_t size : {10'000U, 10'000'000U}) {  // fails in commit(), and in write()
    {
      const FileSizeLimit limit(4096);
      failure = failure_of([&] { write_text(path, std::string(size, 'x')); });
    }
    EXPECT_THAT(failure, AllOf(HasSubstr(path.string()), HasSubstr("File too large")));
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("a"));
  }
}

}  // namespace
}  // namespace restframe

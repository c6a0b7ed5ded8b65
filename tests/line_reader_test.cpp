#include "importers/line_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/error.h"
#include "support/temporary_folder.h"

namespace restframe {
namespace {

using testing::HasSubstr;

class Lines : public testing::Test {
 protected:
  std::vector<std::string> lines_of(const std::string& text) {
    LineReader reader(files_.write("text", text), 10'000'000);
    std::vector<std::string> result;
    for (std::string_view line; reader.next_line(line);) result.emplace_back(line);
    return result;
  }

  TemporaryFolder files_;
};

TEST_F(Lines, EndInThreeWays) {
  const std::vector<std::string> expected = {"a", "", "b"};
  EXPECT_EQ(lines_of("a\n\nb\n"), expected);
  EXPECT_EQ(lines_of("a\r\n\r\nb\r\n"), expected);
  EXPECT_EQ(lines_of("a\r\rb\r"), expected);
  EXPECT_EQ(lines_of("a\r\n\nb"), expected);
  EXPECT_THAT(lines_of(""), testing::IsEmpty());
}

// Blocks are read one after the other: wherever one ends, the lines are the same.
TEST_F(Lines, MayCrossTheBlocks) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (std::size_t shift = 0; shift < 4; ++shift) {
      std::string text(shift, 'x');
      std::vector<std::string> expected;
      for (int i = 0; i < 90'000; ++i)
        text += (expected.emplace_back(std::to_string(i)), expected.back()) + end;
      expected[0].insert(0, shift, 'x');
      EXPECT_EQ(lines_of(text), expected);
    }
  }
  const std::string one(3'000'000, 'y');
  EXPECT_EQ(lines_of(one + "\nz"), std::vector<std::string>({one, "z"}));
}

TEST_F(Lines, ABackslashJoinsThem) {
  EXPECT_EQ(lines_of("a\\\nb\\\r\nc\nd\\"), std::vector<std::string>({"a b c", "d "}));
}

TEST_F(Lines, KnowWhereTheirWordsAre) {
  LineReader reader(files_.write("text", "one\ntwo \\\n  three \\\nfour\nfive"), 1000);
  std::string_view line;
  reader.next_line(line);
  reader.next_line(line);
  for (const auto& [word, line_number, column] :
       {std::tuple("two", 2U, 1U), std::tuple("three", 3U, 3U), std::tuple("four", 4U, 1U)}) {
    const LineReader::Place place = reader.place(line.substr(line.find(word)));
    EXPECT_EQ(place.line, line_number) << word;
    EXPECT_EQ(place.column, column) << word;
  }
  reader.next_line(line);
  EXPECT_THAT(reader.position(reader.place(line)), HasSubstr("text:5:1"));
}

TEST_F(Lines, ANulByteIsFoundInItsLine) {
  std::string text(300'000, '\n');
  text += std::string("ab\0c", 4);
  try {
    lines_of(text);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::EndsWith("text:300001:3: a NUL byte: this is not a text file"));
  }
}

}  // namespace
}  // namespace restframe

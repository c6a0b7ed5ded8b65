#include "importers/paper_intervals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace restframe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const ValueRule color{true, {}};
const ValueRule fraction{false, from_to(0, 1)};

class PaperIntervals : public ::testing::Test {
 protected:
  IntervalFunction read(const std::string& text, const ValueRule& rule = color) {
    return read_paper_intervals(folder_.write("blink.txt", text), rule);
  }
  // Faults, without the file's name.
  std::vector<std::string> faults(const std::string& text, const ValueRule& rule = color) {
    try {
      read(text, rule);
    } catch (const InputError& error) {
      std::vector<std::string> lines;
      const std::string file = (folder_.path() / "blink.txt").string();
      for (const std::string& line : error.faults()) {
        EXPECT_EQ(line.substr(0, file.size() + 1), file + ":");
        lines.push_back(line.substr(file.size() + 1));
      }
      return lines;
    }
    return {};
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(PaperIntervals, ReadsThePapersBlinkingBall) {
  const IntervalFunction blink =
      read("% period 1.0\n% interval 0 0.5 Yellow\n% interval 0.5 1.0 Blue\n");
  EXPECT_EQ(blink.period, 1.0);
  ASSERT_EQ(blink.intervals.size(), 2U);
  EXPECT_EQ(blink.intervals[0].begin, 0);
  EXPECT_EQ(blink.intervals[0].end, 0.5);
  EXPECT_EQ(blink.intervals[0].value, TemporalValue(1, 1, 0));
  EXPECT_EQ(blink.intervals[1].end, 1);
  EXPECT_EQ(blink.intervals[1].value, TemporalValue(0, 0, 1));
}

TEST_F(PaperIntervals, BearsCommentsBlanksAndAnyOrder) {
  const IntervalFunction blink = read(
      "# a comment\r\n\r\n  %interval\t2 3 #f00  # red\r\n%   interval -1 0 #0000FF\r\n   # end");
  EXPECT_EQ(blink.period, std::nullopt);
  ASSERT_EQ(blink.intervals.size(), 2U);
  EXPECT_EQ(blink.intervals[0].value, TemporalValue(0, 0, 1));
  EXPECT_EQ(blink.intervals[1].value, TemporalValue(1, 0, 0));
}

TEST_F(PaperIntervals, ReadsNumbers) {
  const IntervalFunction glow = read("% period 2\n% interval 0 1 0.25", fraction);
  EXPECT_EQ(glow.intervals.at(0).value.x, 0.25F);
}

TEST_F(PaperIntervals, NamesTheLineAndColumnOfAFault) {
  EXPECT_THAT(faults("% period 0\n% interval 0 1 red"),
              ElementsAre(HasSubstr("1:10: the period is 0, must be above 0")));
  EXPECT_THAT(faults("% interval 0 1 yelow"),
              ElementsAre(HasSubstr(
                  "1:16: the colour is \"yelow\", which is no colour; the nearest is \"yellow\"")));
  EXPECT_THAT(faults("\n% interval 0 x red"),
              ElementsAre(HasSubstr("2:14: the end is \"x\", must be a number")));
  EXPECT_THAT(faults("% interval 0 nan red"), ElementsAre(HasSubstr("1:14: the end is nan")));
  EXPECT_THAT(faults("% interval 0 1e999 red"), ElementsAre(HasSubstr("1:14: ")));
  EXPECT_THAT(faults("% interval 0 1"),
              ElementsAre(HasSubstr("1:1: 4 words, must be \"% interval BEGIN END COLOUR\"")));
  EXPECT_THAT(faults("% interval 0 1 red blue"), ElementsAre(HasSubstr("1:20: 6 words")));
  EXPECT_THAT(faults("% intervals 0 1 red"),
              ElementsAre(HasSubstr("\"% intervals\" is unknown, the nearest is \"% interval\"")));
  EXPECT_THAT(faults("% interval 0 1 red\n  hello"), ElementsAre(HasSubstr("2:3: \"hello\"")));
  EXPECT_THAT(faults("% interval 0 1 red\n%"), ElementsAre(HasSubstr("2:1: ")));
  EXPECT_THAT(faults("% period 1\n% period 2\n% interval 0 1 red"),
              ElementsAre(HasSubstr("2:3: the period is given twice")));
  EXPECT_THAT(faults("% interval 0 1 2", fraction),
              ElementsAre(HasSubstr("1:16: the value is 2, must be from 0 to 1")));
}

TEST_F(PaperIntervals, NamesIntervalsThatCanNotStandTogether) {
  EXPECT_THAT(faults("% interval 0 1 red\n% interval 0.5 2 blue"),
              ElementsAre(HasSubstr("2:12: the interval from 0.5 to 2 overlaps that from 0 to 1")));
  EXPECT_THAT(faults("% interval 0 2 red\n% period 1"),
              ElementsAre(HasSubstr("1:12: the interval from 0 to 2 leaves the period, 0 to 1")));
  EXPECT_THAT(faults("% interval 1 1 red"),
              ElementsAre(HasSubstr("1:12: the interval from 1 to 1 is empty")));
  EXPECT_THAT(faults(""), ElementsAre(HasSubstr("no interval")));
}

TEST_F(PaperIntervals, ListsAllFaultsInTheFilesOrder) {
  EXPECT_THAT(faults("% interval 1 1 red\n% interval 0 1 rde\nx"),
              ElementsAre(HasSubstr("1:12: "), HasSubstr("2:16: "), HasSubstr("3:1: ")));
}

TEST_F(PaperIntervals, RefusesWhatIsNoFile) {
  EXPECT_THROW(read_paper_intervals("/nowhere/blink.txt", color), InputError);
  EXPECT_THROW(read_paper_intervals(std::filesystem::temp_directory_path(), color), InputError);
  EXPECT_THROW(read_paper_intervals("/dev/zero", color), InputError);
}

}  // namespace
}  // namespace restframe

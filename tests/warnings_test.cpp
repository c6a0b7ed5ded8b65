#include "importers/warnings.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace restframe {
namespace {

TEST(Warnings, AreALineEachWhateverTheyQuote) {
  Warnings warnings{"a.mtl: not used: no\x01rm"};
  warnings.push_back("two\nlines");
  EXPECT_EQ(warnings, (Warnings{"a.mtl: not used: no?rm", "two?lines"}));
  EXPECT_EQ(warnings[0], "a.mtl: not used: no?rm");
}

TEST(InputError, HasFaultsOfALineEach) {
  const InputError error(std::vector<std::string>{"a\tb", "c\nd"});
  EXPECT_STREQ(error.what(), "a?b");
  EXPECT_EQ(error.faults(), (std::vector<std::string>{"a?b", "c?d"}));
  EXPECT_STREQ(InputError("e\x7f").what(), "e?");
}

}  // namespace
}  // namespace restframe

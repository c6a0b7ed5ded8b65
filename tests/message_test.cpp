#include "scene/message.h"

#include <gtest/gtest.h>

namespace restframe {
namespace {

TEST(Message, StaysOnOneLine) {
  EXPECT_EQ(on_one_line("a\nb\r\tc\x7f"), "a?b??c?");
  EXPECT_EQ(on_one_line("\xc3\xa4"), "\xc3\xa4");  // UTF-8 as it is
}

TEST(Message, QuotesAreShort) {
  EXPECT_EQ(quote(""), "\"\"");
  EXPECT_EQ(quote("two\nlines"), "\"two?lines\"");
  EXPECT_EQ(quote(std::string(80, 'x')), '"' + std::string(80, 'x') + '"');
  EXPECT_EQ(quote(std::string(81, 'x')), '"' + std::string(80, 'x') + "...\"");
}

}  // namespace
}  // namespace restframe

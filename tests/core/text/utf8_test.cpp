// SPDX-License-Identifier: MIT
#include "core/text/utf8.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

TEST(Utf8Test, KeepsTextOfCharactersAsItIs) {
  for (const char* text : {"", "plain\n", "S\xc3\xa4ule", "\xe6\x9f\xb1", "\xf0\x9f\x98\x80", "\xed\x9f\xbf",
                           "\xee\x80\x80", "\xf4\x8f\xbf\xbf", "\xef\xbf\xbd"}) {
    EXPECT_EQ(as_utf8(text), text);
  }
  EXPECT_EQ(as_utf8(std::string_view("a\0b", 3)), std::string_view("a\0b", 3));
}

// RFC 3629: cut off, alone in the middle, longer than need be, half a pair of UTF-16, beyond the last code.
TEST(Utf8Test, ReplacesEachByteThatIsNoPartOfACharacter) {
  const std::string mark = "\xef\xbf\xbd";
  EXPECT_EQ(as_utf8("a\xff"
                    "b"),
            "a" + mark + "b");
  EXPECT_EQ(as_utf8("\xe2\x82"), mark + mark);
  EXPECT_EQ(as_utf8("\x80\xc3\xa4"), mark + "\xc3\xa4");
  for (const std::string text :
       {"\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80"}) {
    std::string marks;
    for (std::size_t i = 0; i < text.size(); ++i) marks += mark;
    EXPECT_EQ(as_utf8(text), marks);
  }
}

}  // namespace
}  // namespace scanbed

#include "scene/printable.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Printable, KeepsLettersOfAnyScript) {
  for (const char* text : {"", "Küche · 厨房 · مطبخ", "\u00a0\u2029\u2065\u206a\u2028"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, BlanksWhatCommandsATerminal) {
  EXPECT_EQ(printable("a\x1b[31mb\r\nc\x7f"), "a [31mb  c ");
  EXPECT_EQ(printable("\u0080\u009b31m\u009f"), "  31m ");
  EXPECT_EQ(printable("x\u202a\u202e\u2066\u2069y"), "x    y");
}

TEST(Printable, TakesWhatIsNoUtf8) {
  EXPECT_EQ(printable("\xc2"), "\xc2");
  EXPECT_EQ(printable("\xe2\x80"), "\xe2\x80");
  EXPECT_EQ(printable("\xff\x80\x9b"), "\xff\x80\x9b");
}

}  // namespace
}  // namespace enfilade

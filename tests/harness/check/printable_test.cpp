#include "harness/text/printable.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(Printable, KeepsPlainTextAndAccents) { EXPECT_EQ(printable("F = 3 N\n\tÁngulo λ"), "F = 3 N\n\tÁngulo λ"); }

TEST(Printable, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(printable("\x1b[31m"), "\\x1b[31m");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("a\rb\x7f"), "a\\x0db\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\x9b");  // a one-character escape sequence
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "abc"),
            "\\u{202e}abc");  // right-to-left override
}

TEST(Printable, ShowsBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");           // cut short
}

TEST(Printable, CutsByLinesAndBytes) {
  EXPECT_EQ(cutText("a\nb\n", 2, 100), "a\nb\n");
  EXPECT_EQ(cutText("a\nb\nc\n", 2, 100), "a\nb\n... (2 more bytes)\n");
  EXPECT_EQ(cutText("abcdef", 9, 4), "abcd\n... (2 more bytes)\n");
  EXPECT_EQ(cutText("a\xc3\xa9z", 9, 2), "a\n... (3 more bytes)\n");  // not through the é
  EXPECT_EQ(cutText("", 9, 4), "");
}

TEST(Printable, IndentsEveryLine) { EXPECT_EQ(indented("a\nb", "> "), "> a\n> b"); }

}  // namespace
}  // namespace muelle

#include "base/text/printable.h"
#include "base/text/utf8.h"
#include "support/hostile_texts.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(Printable, LeavesTextAlone) {
  const std::string text = "Año nuevo: F = −k (L − L0), 日本語 🙂 <b>&amp;</b>";
  EXPECT_EQ(printableLine(text), text);
  EXPECT_EQ(printableText(text + "\nand more"), text + "\nand more");
}

TEST(Printable, SpellsControlCharactersOut) {
  EXPECT_EQ(printableLine("a\x1b[31mb\x07\x7f"), "a\\x1b[31mb\\x07\\x7f");
  EXPECT_EQ(printableLine(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printableLine("\xc2\x9b"
                          "31m"),
            "\\u{9b}31m");
}

TEST(Printable, KeepsLinesOnlyWhereTheyAreWanted) {
  EXPECT_EQ(printableLine("a\nb\r\nc\td"), "a\\nb\\r\\nc d");
  EXPECT_EQ(printableText("a\nb\r\nc\td\re"), "a\nb\nc    d\\re");
}

TEST(Printable, SpellsInvalidUtf8Out) {
  EXPECT_EQ(printableLine("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printableLine("\xc0\xaf"), "\\xc0\\xaf");                    // overlong "/"
  EXPECT_EQ(printableLine("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");           // overlong "/"
  EXPECT_EQ(printableLine("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(printableLine("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // above U+10FFFF
  EXPECT_EQ(printableLine("a\xe2\x82"), "a\\xe2\\x82");                  // cut short
}

TEST(Printable, SpellsHiddenCharactersOut) {
  EXPECT_EQ(printableLine("a\u202eb\u2066c\u200fd\u061ce"), "a\\u{202e}b\\u{2066}c\\u{200f}d\\u{61c}e");
  EXPECT_EQ(printableLine("\ufeff\u200b\u2028\U000e0041\uffff"), "\\u{feff}\\u{200b}\\u{2028}\\u{e0041}\\u{ffff}");
}

TEST(Printable, IsIdempotentAndValid) {
  for (const std::string& text : hostileTexts()) {
    const std::string once = printableText(text);
    EXPECT_EQ(printableText(once), once);
    for (std::string_view rest = once; !rest.empty(); rest.remove_prefix(decodeUtf8(rest).length))
      ASSERT_TRUE(decodeUtf8(rest).valid);
  }
}

TEST(CutText, CutsByLinesAndBytes) {
  EXPECT_EQ(cutText("a\nb\n", 2, 100), "a\nb\n");
  EXPECT_EQ(cutText("a\nb\nc\n", 2, 100), "a\nb\n... (2 more bytes)\n");
  EXPECT_EQ(cutText("abcdef", 9, 4), "abcd\n... (2 more bytes)\n");
  EXPECT_EQ(cutText("a\xc3\xa9z", 9, 2), "a\n... (3 more bytes)\n");  // not through the é
  EXPECT_EQ(cutText("", 9, 4), "");
}

TEST(Indented, IndentsEveryLine) { EXPECT_EQ(indented("a\nb", "> "), "> a\n> b"); }

TEST(Cut, EndsAtACharacter) {
  EXPECT_EQ(cut("aññb", 2), "a...");
  EXPECT_EQ(cut("aññb", 3), "añ...");
  EXPECT_EQ(cut("aññb", 6), "aññb");
}

TEST(Columns, CountWideAndCombiningCharacters) {
  EXPECT_EQ(columns("año"), 3);
  EXPECT_EQ(columns("an\u0303o"), 3);
  EXPECT_EQ(columns("日本"), 4);
  EXPECT_EQ(columns("🙂"), 2);
}

}  // namespace
}  // namespace muelle

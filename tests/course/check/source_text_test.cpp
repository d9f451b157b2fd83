#include "course/check/source_text.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

/// Two bytes a character of `text` (which is ASCII or Latin-1), behind the byte order mark.
std::string utf16(const std::string& text, bool bigEndian) {
  std::string bytes = bigEndian ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) bytes += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

TEST(SourceText, OfUtf16BecomesUtf8AndSaysSo) {
  for (const bool bigEndian : {false, true}) {
    const SourceText source = readSource(utf16("double f(); // \xe9\r\n", bigEndian));
    EXPECT_EQ(source.text, "double f(); // é\r\n");
    EXPECT_EQ(source.note, "converted from UTF-16");
    EXPECT_EQ(source.refusal, "");
  }
}

TEST(SourceText, OfUtf16MayHaveSurrogatePairs) {
  EXPECT_EQ(readSource(std::string("\xff\xfe\x3d\xd8\x00\xde", 6)).text, "😀");
  EXPECT_EQ(readSource(std::string("\xfe\xff\x20\xac", 4)).text, "€");
}

TEST(SourceText, OfBrokenUtf16IsRefused) {
  for (const std::string& bytes : {std::string("\xff\xfe"
                                               "a",
                                               3),
                                   std::string("\xff\xfe\x00\xd8", 4), std::string("\xff\xfe\x00\xdc", 4),
                                   std::string("\xff\xfe\x00\xd8"
                                               "a\0",
                                               6)})
    EXPECT_EQ(readSource(bytes).refusal, "is no text: it begins as UTF-16 and is none; save it as UTF-8");
}

TEST(SourceText, LosesTheMarkOfUtf8) {
  const SourceText source = readSource("\xef\xbb\xbfint a;\n");
  EXPECT_EQ(source.text, "int a;\n");
  EXPECT_EQ(source.note, "");
}

TEST(SourceText, WithNulIsRefused) {
  EXPECT_EQ(readSource(std::string("int\0a;", 6)).refusal, "is no text: byte 4 is NUL; save it as UTF-8");
  // UTF-32 begins as UTF-16 does.
  EXPECT_NE(readSource(std::string("\xff\xfe\0\0i\0\0\0", 8)).refusal.find("is no text"), std::string::npos);
}

TEST(SourceText, OfAnOldMacGetsLines) {
  const SourceText source = readSource("#include \"a.h\"\rint a;\r");
  EXPECT_EQ(source.text, "#include \"a.h\"\nint a;\n");
  EXPECT_EQ(source.note, "its line ends, carriage returns alone, made line feeds");
}

TEST(SourceText, OtherwiseStaysByteByByte) {
  for (const std::string& bytes : {std::string("a\r\nb\rc\n"), std::string("// \xe9 in Latin-1\n"), std::string()}) {
    const SourceText source = readSource(bytes);
    EXPECT_EQ(source.text, bytes);
    EXPECT_EQ(source.note, "");
    EXPECT_EQ(source.refusal, "");
  }
}

}  // namespace
}  // namespace muelle

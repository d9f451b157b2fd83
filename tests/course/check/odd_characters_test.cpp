#include "course/check/odd_characters.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

std::vector<Diagnostic> found(const std::string& text) { return oddCharacters({"a.cpp", text}); }

TEST(OddCharacters, AreNamedWithWhatToType) {
  const std::vector<Diagnostic> list = found("int x;\nreturn\u00a0-k;\n");
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].line, 2);
  EXPECT_EQ(list[0].column, 7);
  EXPECT_EQ(list[0].message, "a no-break space (U+00A0) stands here");
  EXPECT_EQ(list[0].explanation, "type an ordinary space");
  EXPECT_EQ(found("return \u2212k;")[0].explanation, "type - of the keyboard");
  EXPECT_EQ(found("k\u200b = 1;").size(), 1U);
  EXPECT_EQ(found("char c = \u2018a\u2019;").size(), 1U) << "one a line";
  EXPECT_EQ(found("```cpp\nint x;\n```\n").size(), 2U);
  EXPECT_EQ(found("double a\xf1o = 1;")[0].message,
            "a byte that is no UTF-8, as an accent saved in Latin-1 stands here");
}

TEST(OddCharacters, MayStandInCommentsAndTexts) {
  EXPECT_TRUE(found("// caf\xe9 \u2212 \u201cquoted\u201d\n/* ``` \u00a0 */ const char* s = \"\u2212\"; int x = 1'000;")
                  .empty());
  EXPECT_TRUE(found("double a\u00f1o = 1;").empty()) << "a letter may stand in a name";
}

}  // namespace
}  // namespace muelle

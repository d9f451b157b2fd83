#include "grader/matrix/token.h"

#include <gtest/gtest.h>
#include <string>

namespace {

using muelle::grader::Token;
using muelle::grader::tokenise;

std::vector<std::string> texts(std::string_view source) {
  std::vector<std::string> result;
  for (const Token& token : tokenise(source)) result.emplace_back(token.text);
  return result;
}

using Texts = std::vector<std::string>;

TEST(Tokens, SplitsNamesNumbersAndOperators) {
  EXPECT_EQ(texts("a+=b*1.5e-3;"), (Texts{"a", "+=", "b", "*", "1.5e-3", ";"}));
  EXPECT_EQ(texts("x<=y&&!z"), (Texts{"x", "<=", "y", "&&", "!", "z"}));
}

TEST(Tokens, SkipsCommentsAndDirectives) {
  EXPECT_EQ(texts("#include \"a.h\"\n#define B 1 + \\\n  2\nx // - y\n/* - */ z"), (Texts{"x", "z"}));
}

TEST(Tokens, TakesTextsAsOne) {
  EXPECT_EQ(texts("f(\"a \\\" - b\", '+', R\"x(1 + \")\" 2)x\")"),
            (Texts{"f", "(", "\"a \\\" - b\"", ",", "'+'", ",", "R\"x(1 + \")\" 2)x\"", ")"}));
}

TEST(Tokens, HasPlaces) {
  const std::vector<Token> tokens = tokenise("a\n  - b");
  EXPECT_EQ(tokens[1].offset, 4u);
  EXPECT_TRUE(tokens[1].spaceBefore);
}

TEST(Tokens, TellsTemplateListsFromComparisons) {
  const std::string source = "std::vector<std::array<double, 3>> v; if (a < b) v.head<3>(); x = i < 3 && j > 2;";
  for (const Token& token : tokenise(source)) {
    const bool inList =
        token.text == "double" || token.text == "std" || (token.text == "3" && source[token.offset + 1] == '>');
    const bool atStart = token.offset == 0;  // the first std
    if (token.kind != Token::Kind::Operator && !atStart && token.text != "array") {
      EXPECT_EQ(token.inTemplateList, inList) << token.text << " at " << token.offset;
    }
  }
}

TEST(Tokens, EndsWhereAnUnfinishedTextEnds) {
  EXPECT_EQ(texts("a \"b"), (Texts{"a", "\"b"}));
  EXPECT_EQ(texts("a /* b"), (Texts{"a"}));
  EXPECT_EQ(texts(""), Texts{});
}

}  // namespace

#include "grader/naming/function_text.h"

#include "spring_history.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

TEST(FunctionText, CutsTheDefinitionOutNotACall) {
  const std::string source =
      "double twice(double x) { return 2 * force(x, 1, 0); }\n"
      "double force(double x, double k, double L0) {\n  if (x > 0) { return k; }\n  return L0;\n}\n";
  const auto text = functionText(source, "force");
  ASSERT_TRUE(text);
  EXPECT_EQ(text->parameters, "double x, double k, double L0");
  EXPECT_EQ(text->body, "\n  if (x > 0) { return k; }\n  return L0;\n");
  EXPECT_FALSE(functionText("double force(double x, double k, double L0);", "force"));
  EXPECT_FALSE(functionText("double force(double x) { return x;", "force")) << "a brace is missing";
}

TEST(FunctionText, CutsTheDeclarationOutOfAContract) {
  const auto force = declarationText(springContract, "force");
  ASSERT_TRUE(force);
  EXPECT_EQ(force->result, "double");
  EXPECT_EQ(force->parameters, "double x, double k, double L0");
  EXPECT_EQ(declarationText(springContract, "acceleration")->parameters,
            "double x, double k, double L0, const std::vector<double>& m");
  EXPECT_FALSE(declarationText(springContract, "velocity"));
}

}  // namespace
}  // namespace muelle::grader

#include "grader/matrix/expectation.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace {

using muelle::Manifest;
using muelle::grader::Expectation;
using muelle::grader::readExpectation;

Manifest manifest() {
  Manifest result;
  result.topic = "spring";
  for (const char* suite : {"HookeForce", "ThirdLaw", "ZeroLength"}) {
    result.criteria.push_back({suite, suite, 1.0, false, "", {}});
  }
  result.misconceptions.push_back({"wrong_sign", "f", "", ""});
  return result;
}

Expectation read(const std::string& source) { return readExpectation(source, "a/b.cpp", manifest()); }

std::string complaint(const std::string& source) {
  try {
    read(source);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(FirstLine, StatesSuitesAndMisconception) {
  const Expectation expectation = read("// loses: HookeForce, ZeroLength; misconception: wrong_sign\nint x;\n");
  EXPECT_EQ(expectation.lost, (std::set<std::string>{"HookeForce", "ZeroLength"}));
  EXPECT_EQ(expectation.named, (std::set<std::string>{"wrong_sign"}));
  EXPECT_FALSE(expectation.noPoints);
}

TEST(FirstLine, AllIsEverySuiteAndNoPoint) {
  const Expectation expectation = read("// loses: all; misconception: none\r\n");
  EXPECT_EQ(expectation.lost.size(), 3u);
  EXPECT_TRUE(expectation.noPoints);
  EXPECT_TRUE(expectation.named.empty());
}

TEST(FirstLine, IsRefusedWithFileAndLine) {
  for (const char* line : {"#include \"b.h\"", "", "// loses: HookeForce", "// loses: ; misconception: none",
                           "// loses: HookeForce,; misconception: none", "// loses: HookeForce; misconception:",
                           "// loses: HookeForce, all; misconception: none", "// loses: HookeForce; names: wrong_sign",
                           "// loses: ThirdLaw, ThirdLaw; misconception: none"}) {
    EXPECT_TRUE(complaint(line).starts_with("a/b.cpp:1: ")) << line << " -> " << complaint(line);
    EXPECT_EQ(complaint(line).find('\n'), std::string::npos);
  }
}

TEST(FirstLine, UnknownNamesHaveANearestOne) {
  EXPECT_NE(complaint("// loses: HokeForce; misconception: none").find("did you mean 'HookeForce'"), std::string::npos);
  EXPECT_NE(complaint("// loses: all; misconception: wrongsign").find("did you mean 'wrong_sign'"), std::string::npos);
}

}  // namespace

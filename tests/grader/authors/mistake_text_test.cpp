#include "grader/authors/mistake_text.h"

#include "spring_history.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

UnnamedGroup groupOf(const std::string& source) {
  return {
      "spring", {"ana", "be\x1bn"}, {"acceleration", {}, CounterExample{"acceleration", {"2", "1"}, {3}, {4}}}, source};
}

TEST(MistakeText, BeginsWithTheHandInsOwnFunction) {
  const std::string source =
      "double acceleration(double x, double k, double l, const std::vector<double>& m) {\n"
      "  return force(x, k, l) / m[0];\n}\n";
  EXPECT_EQ(groupText(groupOf(source), springContract),
            R"(2 hand-ins of spring are wrong alike in acceleration, without a name: ana, be\x1bn
  acceleration(2, 1): you return 3, it is 4
  tests/hidden/spring/mistakes.cpp:

MUELLE_MISTAKE(acceleration, some_id, [](double x, double k, double l, const std::vector<double>& m) -> double {
  return oracle::force(x, k, l) / m[0];
});

  exercises/spring/exercise.toml:

[[misconception]]
id = "some_id"
function = "acceleration"
says = "what the student did"
hint = "how to mend it"
)");
}

TEST(MistakeText, BeginsWithTheOraclesCallWhereNothingCanBeCutOut) {
  EXPECT_NE(mistakeText(groupOf("#define HEAD double acceleration"), springContract)
                .find(R"([](double x, double k, double L0, const std::vector<double>& m) -> double {
  return oracle::acceleration(x, k, L0, m);  // with the mistake in it
});)"),
            std::string::npos);
}

}  // namespace
}  // namespace muelle::grader

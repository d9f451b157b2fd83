#include "grader/authors/same_mistakes.h"

#include "grader/testing/gather_evidence.h"
#include "grader/testing/listed_mistakes.h"
#include "spring_history.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

double twice(double x, double k, double L0) { return 2 * rightForce(x, k, L0); }
double addedToItself(double x, double k, double L0) { return rightForce(x, k, L0) + rightForce(x, k, L0); }
/// Twice the force of springs longer than 1 m alone.
double twiceWhereLong(double x, double k, double L0) { return (x > 1 ? 2 : 1) * rightForce(x, k, L0); }

/// A criterion that the solution passes, of `count` springs of length `shortest` and more.
Verdict passed(int count, double shortest) {
  ForceHistory history;
  history.addMistake("twice", twice);
  history.addMistake("counted_twice", addedToItself);
  history.addMistake("twice_where_long", twiceWhereLong);
  history.addMistake("sign", [](double x, double k, double L0) { return -rightForce(x, k, L0); });
  history.addMistake("at_infinity", [](double x, double k, double L0) { return x > 1e9 ? 0 : rightForce(x, k, L0); });
  ask(history, rightForce, count, shortest);
  Verdict verdict;
  FunctionEvidence& evidence = verdict.evidence["force"] = gatherEvidence(history);
  evidence.listed = listedMistakes(history);
  return verdict;
}

TEST(SameMistakes, AreToldWhereNoCallTellsThemApart) {
  const std::vector<std::string> lines = mistakesNotToldApart({{"Force", passed(12, 0.2)}});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "at_infinity of force is right in every call: ask for what it spoils, or take it out");
  EXPECT_EQ(lines[1],
            "counted_twice and twice of force give the same numbers in every call: make them one, or ask for what "
            "differs");
}

TEST(SameMistakes, AreTwoWhereOneCriterionTellsThemApart) {
  // All springs of the first criterion are long: there twice_where_long is the same as twice.
  EXPECT_EQ(mistakesNotToldApart({{"Long", passed(12, 1.2)}})[1],
            "counted_twice and twice and twice_where_long of force give the same numbers in every call: make them one, "
            "or ask for what differs");
  EXPECT_EQ(mistakesNotToldApart({{"Long", passed(12, 1.2)}, {"Force", passed(12, 0.2)}})[1],
            "counted_twice and twice of force give the same numbers in every call: make them one, or ask for what "
            "differs");
}

}  // namespace
}  // namespace muelle::grader

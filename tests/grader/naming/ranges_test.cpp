#include "grader/matrix/ranges.h"

#include "grader/testing/gather_evidence.h"
#include "spring_history.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

void add(ForceHistory& history, double k, double L0) {
  history.add(std::make_shared<const std::tuple<double, double, double>>(0.7, k, L0), {rightForce(0.7, k, L0)});
}

TEST(Ranges, AreToBePassedAtBothEnds) {
  ForceHistory history;
  ask(history, rightForce);
  const auto lines = [&history] { return endsNotPassed(springContract, {{"force", gatherEvidence(history)}}); };
  const std::vector<std::string> before = lines();
  ASSERT_EQ(before.size(), 4U);
  EXPECT_EQ(before[0], "force: k is never 0.001, the least is 11.3");
  add(history, 1e-3, 0.0);
  add(history, 1e9, 10.0);
  EXPECT_TRUE(lines().empty());
}

}  // namespace
}  // namespace muelle::grader

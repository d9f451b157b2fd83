#include "grader/matrix/ranges.h"

#include "grader/testing/gather_evidence.h"
#include "spring_history.h"

#include <gtest/gtest.h>

#include <vector>

namespace muelle::grader {
namespace {

void add(ForceHistory& history, double k, double L0) {
  history.add(withoutTypes(std::tuple<double, double, double>(0.7, k, L0)), {rightForce(0.7, k, L0)});
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

TEST(Ranges, OfAListIsThatOfItsLength) {
  CallHistory<double(const std::vector<double>&)> history;
  history.setOracle([](const std::vector<double>& m) { return m.empty() ? 0.0 : m.front(); });
  const auto pass = [&history](std::vector<double> m) {
    history.add(withoutTypes(std::tuple<std::vector<double>>(m)), {m.empty() ? 0.0 : m.front()});
  };
  pass({});
  pass({0.5, 0.25, 0.75});
  const char* contract = "double first(const std::vector<double>& m);\nMUELLE_RANGE(m, 0, 3)\n";
  EXPECT_TRUE(endsNotPassed(contract, {{"first", gatherEvidence(history)}}).empty());
}

}  // namespace
}  // namespace muelle::grader

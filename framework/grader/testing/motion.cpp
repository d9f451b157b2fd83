#include "grader/testing/motion.h"

#include "course/testing/expect.h"
#include "harness/function_system.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

void expectSameNumbers(const std::vector<double>& got, const std::vector<double>& expected, const char* what, double t,
                       const char* unit, double tolerance) {
  const int nodes = static_cast<int>(expected.size()) / 3;
  for (int i = 0; i < nodes; ++i) {
    const std::string node = nodes == 1 ? "" : fmt::format(" of node {}", i);
    MUELLE_LABEL(fmt::format("{}{} at t = {:.4g} s", what, node, t), unit);
    EXPECT_VECTOR_NEAR(Vec3(node3(In(got), i)), Vec3(node3(In(expected), i)), tolerance);
  }
}

}  // namespace

::testing::AssertionResult wentOn(const char* /*text*/, const Trajectory& trajectory) {
  if (!trajectory.stop.stopped) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << trajectory.stop.message;
}

void expectSameMotion(const Trajectory& trajectory, const Trajectory& reference, double tolerance) {
  const ::testing::TestResult& test = *::testing::UnitTest::GetInstance()->current_test_info()->result();
  const int failedBefore = test.total_part_count();
  const std::size_t count = std::min(trajectory.t.size(), reference.t.size());
  for (std::size_t i = 0; i < count && test.total_part_count() == failedBefore; ++i) {
    const double t = reference.t[i];
    expectSameNumbers(trajectory.x[i], reference.x[i], "position", t, "m", tolerance);
    expectSameNumbers(trajectory.v[i], reference.v[i], "velocity", t, "m/s", tolerance);
  }
  MUELLE_EXPECT_WENT_ON(trajectory);
}

}  // namespace muelle::grader

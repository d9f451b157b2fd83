#include "fixture.h"
#include "fixture_session.h"

#include "course/testing/test_function.h"

#include <cmath>
#include <limits>

namespace {

using RemoteCall = muelle::grader::FixtureSession;

TEST_F(RemoteCall, CarriesNumbers) {
  EXPECT_EQ(submission::sum(1.5, -4, false), -2.5);
  EXPECT_EQ(submission::sum(1.5, -4, true), 2.5);
  EXPECT_TRUE(std::isnan(submission::sum(std::nan(""), 1, false)));
  EXPECT_TRUE(std::signbit(submission::sum(-0.0, 0, true)));
  EXPECT_EQ(submission::sum(std::numeric_limits<double>::infinity(), 1, true),
            -std::numeric_limits<double>::infinity());
}

TEST_F(RemoteCall, CarriesVectorsAndMatrices) {
  EXPECT_EQ(submission::scaled(Vec3(1, 2, 3), -2), Vec3(-2, -4, -6));
  EXPECT_EQ(submission::reversed(VecX::LinSpaced(4, 0, 3)), VecX(VecX::LinSpaced(4, 3, 0)));
  EXPECT_EQ(submission::reversed(VecX(0)).size(), 0);
  const MatX m = MatX::Random(3, 5);
  EXPECT_EQ(submission::transposed(m), MatX(m.transpose()));
}

TEST_F(RemoteCall, CarriesSparseMatrices) {
  Eigen::SparseMatrix<double> m(4, 3);
  m.insert(3, 1) = 2;
  m.insert(0, 0) = -1;
  EXPECT_EQ(MatX(submission::twice(m)), MatX(m * 2));
}

TEST_F(RemoteCall, CarriesListsOfStructs) {
  const std::vector<Particle> particles{{1, 0.5, Vec3(1, 0, 0), {}}, {2, 1.5, Vec3(0, 1, 0), {1, 2, 3}}};
  const auto moved = submission::moved(particles, Vec3(0, 0, 1));
  ASSERT_EQ(moved.size(), 2U);
  EXPECT_EQ(moved[1].id, 2);
  EXPECT_EQ(moved[1].x, Vec3(0, 1, 1));
  EXPECT_EQ(moved[1].history, (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(submission::moved({}, Vec3(0, 0, 1)).empty());
  EXPECT_EQ(submission::swapped({1, 2}), (std::array<double, 2>{2, 1}));
}

TEST_F(RemoteCall, BringsBackWhatTheFunctionChanged) {
  Vec3 x(1, 1, 1);
  std::vector<double> times{0.5};
  submission::advance(x, Vec3(0, 2, 0), 0.25, times);
  EXPECT_EQ(x, Vec3(1, 1.5, 1));
  EXPECT_EQ(times, (std::vector<double>{0.5, 0.25}));
}

TEST_F(RemoteCall, LetsTheStudentCallTheTestsFunction) {
  int calls = 0;
  const auto gravity = [&calls](double, const Vec3&) {
    ++calls;
    return Vec3(0, 0, -10);
  };
  const Vec3 x = submission::integrate(gravity, Vec3(0, 0, 0), Vec3(1, 0, 0), 0.1, 10);
  EXPECT_EQ(calls, 10) << "the test counts";
  EXPECT_NEAR(x.x(), 1, 1e-14);
  EXPECT_NEAR(x.z(), -10 * 0.01 * 55, 1e-13) << "v_i = -i, so x = -0.1 (1 + ... + 10)";
  EXPECT_EQ(submission::callTwice([](double y) { return 3 * y; }, 2), 18);
}

TEST_F(RemoteCall, ThrowsInTheStudentsFunctionWhatTheTestThrowsToIt) {
  const auto root = [](double x) {
    if (x < 0) throw muelle::ThrownToAsker("no root");
    return std::sqrt(x);
  };
  EXPECT_EQ(submission::answerOr(root, 4, 7), 2);
  EXPECT_EQ(submission::answerOr(root, -4, 7), 7) << "it was caught, and the worker goes on";
  EXPECT_EQ(submission::answerOr(root, 9, 7), 3);
  EXPECT_EQ(session().fault(), "");
  EXPECT_THROW(submission::callTwice(root, -4), muelle::grader::SubmissionFault) << "nobody caught it";
  EXPECT_NE(session().fault().find("no root"), std::string::npos) << session().fault();
}

TEST_F(RemoteCall, RepeatsCallsUnasked) {
  for (int i = 0; i < 100; ++i) EXPECT_EQ(submission::sum(i, 1, false), i + 1);
  EXPECT_GT(session().calls(), 100);
  EXPECT_EQ(session().fault(), "");
}

}  // namespace

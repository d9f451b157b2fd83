#include "course/testing/direct_functions.h"
#include "harness/types.h"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>

using muelle::Vec3;

double stretch(const Vec3& a, const Vec3& b);
void push(Vec3& x, double by);
double nested(double x);
double derivative(const std::function<double(double)>& f, double x);
MUELLE_FUNCTIONS(stretch, push, nested, derivative)

double stretch(const Vec3& a, const Vec3& b) { return (a - b).norm(); }
void push(Vec3& x, double by) { x.array() += by; }
double derivative(const std::function<double(double)>& f, double x) { return (f(x + 1e-3) - f(x - 1e-3)) / 2e-3; }
double nested(double x) {
  const std::string outer = muelle::CallRecord::current()->function();
  EXPECT_EQ(outer, "nested");
  const double inner = submission::stretch(Vec3(x, 0, 0), Vec3(0, 0, 0));
  EXPECT_STREQ(muelle::CallRecord::current()->function(), "nested");
  return inner;
}

namespace muelle {
namespace {

TEST(DirectFunctions, CallTheStudentsFunctionAndRememberTheCall) {
  EXPECT_DOUBLE_EQ(submission::stretch(Vec3(3, 0, 0), Vec3(0, 4, 0)), 5.0);
  EXPECT_EQ(CallRecord::lastCall(), "stretch(Vec3(3, 0, 0), Vec3(0, 4, 0))");
  EXPECT_EQ(CallRecord::current(), nullptr);
}

TEST(DirectFunctions, PassOutParametersOn) {
  Vec3 x(1, 2, 3);
  submission::push(x, 0.5);
  EXPECT_EQ(x, Vec3(1.5, 2.5, 3.5));
  EXPECT_EQ(CallRecord::lastCall(), "push(Vec3(1, 2, 3), 0.5)");
}

TEST(DirectFunctions, KnowTheInnermostCall) { EXPECT_DOUBLE_EQ(submission::nested(2.0), 2.0); }

TEST(DirectFunctions, KeepWhatWasAskedThatHasNoAnswer) {
  CallRecord::badQuestion().clear();
  const auto root = [](double x) {
    if (x < 0) throw BadQuestion("asks for the root of a negative number");
    return std::sqrt(x);
  };
  EXPECT_NEAR(submission::derivative(root, 1), 0.5, 1e-6);
  EXPECT_EQ(CallRecord::badQuestion(), "");
  EXPECT_THROW(submission::derivative(root, 0), BadQuestion) << "the demo may catch it";
  EXPECT_EQ(CallRecord::badQuestion(), "asks for the root of a negative number");
}

TEST(DirectFunctions, PrintNothingWhileADemoRuns) {
  CallRecord::setLastCall("before");
  CallRecord::printsArguments() = false;
  submission::stretch(Vec3(1, 1, 1), Vec3(1, 1, 1));
  CallRecord::printsArguments() = true;
  EXPECT_EQ(CallRecord::lastCall(), "before");
}

}  // namespace
}  // namespace muelle

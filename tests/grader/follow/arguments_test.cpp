#include "grader/testing/arguments.h"

#include <gtest/gtest.h>

#include <limits>

namespace muelle::grader {
namespace {

/// An examination of a function of two numbers, f(a, b), with the oracle a + 2 b.
Examination examined(double (*own)(double, double)) {
  const auto ask = [own](double a, double b) { return Answers{{own(a, b)}, {a + 2 * b}}; };
  constexpr double as[] = {1.25, -0.5, 3.5};
  constexpr double bs[] = {0.75, 2.25, -1.5};
  Examination examination;
  for (int i = 0; i < 3; ++i) examination.draws.push_back(ask(as[i], bs[i]));
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    examination.exchanged.push_back({0, static_cast<std::size_t>(i), ask(as[next], bs[i])});
    examination.exchanged.push_back({1, static_cast<std::size_t>(i), ask(as[i], bs[next])});
  }
  for (int i = 0; i < 3; ++i) examination.again.push_back({own(as[i], bs[i])});
  return examination;
}

std::string complaint(double (*own)(double, double)) { return judgeUse(examined(own), "f", {"a", "b"}).complaint; }

TEST(OfUse, IsAWrongAnswerThatDependsOnEverything) {
  EXPECT_EQ(complaint([](double a, double b) { return a + 2 * b; }), "");
  EXPECT_EQ(complaint([](double a, double b) { return 5 * a - b; }), "");
}

TEST(OfUse, IsNoFunctionThatGivesNothing) {
  EXPECT_EQ(complaint([](double, double) { return 0.0; }), "f gives zero always");
  EXPECT_EQ(complaint([](double, double) { return 3.0; }), "f gives the same always");
  EXPECT_EQ(complaint([](double a, double) { return a > 3 ? std::numeric_limits<double>::quiet_NaN() : a; }),
            "f gives no number");
  EXPECT_EQ(complaint([](double a, double b) {
              static double calls = 0;
              return a + b + ++calls;
            }),
            "f gives another answer when asked again");
}

TEST(OfUse, NamesTheArgumentThatIsLeftOut) {
  const Uselessness found = judgeUse(examined([](double a, double) { return a; }), "f", {"a", "b"});
  EXPECT_EQ(found.complaint, "f gives the same whatever b is");
  EXPECT_TRUE(found.isOneSlipAway);
  EXPECT_EQ(judgeUse(examined([](double a, double) { return a; }), "f", {}).complaint,
            "f gives the same whatever argument 2 is");
}

TEST(OfUse, ReadsTheNamesOfTheTuple) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(namesInTuple("[](Random& random) { const Vec3 xa = random.vector3(1); return std::tuple(xa, L0); }"),
            (Names{"xa", "L0"}));
  EXPECT_EQ(namesInTuple("[] { return std::tuple{Vec3(0, 1, 2), k}; }"), (Names{"", "k"}));
  EXPECT_EQ(namesInTuple("generator"), Names());
}

}  // namespace
}  // namespace muelle::grader

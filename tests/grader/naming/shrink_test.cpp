#include "grader/testing/shrink.h"

#include "grader/report/example_sentence.h"
#include "spring_history.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <vector>

namespace muelle::grader {
namespace {

std::string simplest(const ForceFunction& own) {
  ForceHistory history;
  ask(history, own);
  const std::size_t calls = history.calls();
  const auto example = simplestCounterExample("force", history, springContract);
  EXPECT_EQ(history.calls(), calls) << "the search leaves no calls behind";
  return example ? exampleSentence(*example) : "none";
}

TEST(Shrink, FindsNumbersForPaper) {
  EXPECT_EQ(simplest([](double x, double k, double L0) { return -rightForce(x, k, L0); }),
            "force(0, 1, 1): you return -1, it is 1");
  EXPECT_EQ(simplest([](double x, double k, double) { return -k * x; }), "force(0, 1, 1): you return -0, it is 1");
}

TEST(Shrink, StaysInTheContractsRanges) {
  // Wrong for soft springs only: k = 0 is not allowed, and 1 shows nothing.
  const std::string found =
      simplest([](double x, double k, double L0) { return k < 15 ? 2 * rightForce(x, k, L0) : rightForce(x, k, L0); });
  EXPECT_EQ(found, "force(0, 1, 1): you return 2, it is 1");
}

TEST(Shrink, KeepsTheMistake) {
  // A square shows at 2, not at 0 or 1, where another mistake would do the same.
  const std::string found = simplest([](double x, double k, double L0) { return -k * (x * x - L0); });
  EXPECT_EQ(found, "force(2, 1, 0): you return -4, it is -2");
}

TEST(Shrink, HasRoomWhereAMotionHasTakenAllCalls) {
  ForceHistory history;
  const auto own = [](double x, double k, double L0) { return -rightForce(x, k, L0); };
  ask(history, own, static_cast<int>(CallHistoryBase::mostCalls) + 5);
  EXPECT_EQ(history.calls(), CallHistoryBase::mostCalls);
  const auto example = simplestCounterExample("force", history, springContract);
  ASSERT_TRUE(example);
  EXPECT_EQ(exampleSentence(*example), "force(0, 1, 1): you return -1, it is 1");
}

TEST(Shrink, AsksNothingOfAConstantButToBeWrong) {
  // "k is ignored" agrees with 0 as well, by chance: it would keep x = L0 from becoming anything else.
  const std::string found = simplest([](double, double, double) { return 0.0; });
  EXPECT_EQ(found, "force(0, 1, 1): you return 0, it is 1");
}

/// Sum of the numbers at some places; throws where there is no such place.
double sumAt(const std::vector<double>& numbers, const std::vector<int>& places) {
  double sum = 0;
  for (const int i : places) sum += numbers.at(static_cast<std::size_t>(i));
  return sum;
}

TEST(Shrink, AsksNothingThatTheOracleRefuses) {
  // A list of places and the list that they are in: either alone may not lose its members.
  using SumHistory = CallHistory<double(const std::vector<double>&, const std::vector<int>&)>;
  SumHistory history;
  history.setOracle(sumAt);
  history.addMistake("needs_three", [](const std::vector<double>& n, const std::vector<int>&) { return n.at(2); });
  const auto own = [&history](const std::vector<double>& numbers, const std::vector<int>& places) {
    const double answer = 2 * sumAt(numbers, places);  // what a submission does with other places is its end
    history.add(withoutTypes(SumHistory::Tuple(numbers, places)), {answer});
    return answer;
  };
  history.setOwn(own);
  own({1.7, 2.9}, {1, 0, 1});
  own({1.3, 2.1, 4.7}, {2, 1});
  const auto example = simplestCounterExample("sumAt", history,
                                              "double sumAt(const std::vector<double>& n, const std::vector<int>& p);");
  ASSERT_TRUE(example);
  EXPECT_EQ(exampleSentence(*example), "sumAt({1, 1}, {1}): you return 2, it is 1");
}

TEST(Shrink, MovesPlacesThatAreNearEachOther) {
  CallHistory<double(const Vec3&, const Vec3&)> history;
  const auto distance = [](const Vec3& a, const Vec3& b) { return 1e9 * (a - b).norm(); };
  const auto own = [&](const Vec3& a, const Vec3& b) { return distance(a, b) < 1 ? 0.0 : distance(a, b); };
  history.setOracle(distance);
  history.setOwn([&](const Vec3& a, const Vec3& b) {
    history.add(withoutTypes(std::tuple<Vec3, Vec3>(a, b)), {own(a, b)});
    return 0.0;
  });
  const Vec3 place(1, 2, 3);
  for (const double apart : {0x1p-20, 0x1p-31, 0x1p-32}) {
    const Vec3 other = place + Vec3(0, 0, apart);
    history.add(withoutTypes(std::tuple<Vec3, Vec3>(other, place)), {own(other, place)});
  }
  const auto example = simplestCounterExample("f", history, "double f(const Vec3& a, const Vec3& b);");
  ASSERT_TRUE(example);
  EXPECT_EQ(exampleSentence(*example), "f(Vec3(0, 0, 5e-10), Vec3(0, 0, 0)): you return 0, it is 0.5");
}

/// Answers for calls of a function of one argument, with `own` to be asked more.
template <class Argument>
std::string simplestOf(CallHistory<double(Argument)>& history, const std::function<double(Argument)>& oracle,
                       const std::function<double(Argument)>& own, const std::vector<std::decay_t<Argument>>& asked) {
  const auto answer = [&history, own](Argument argument) {
    const double number = own(argument);
    history.add(withoutTypes(std::tuple<std::decay_t<Argument>>(argument)), {number});
    return number;
  };
  history.setOracle(oracle);
  history.setOwn(answer);
  for (const auto& each : asked) answer(each);
  const auto example = simplestCounterExample("f", history, "MUELLE_RANGE(m, 1, 40)\ndouble f(double m);");
  return example ? exampleSentence(*example) : "none";
}

TEST(Shrink, SaysTrueOrFalseOfAVerdict) {
  CallHistory<bool(double)> history;
  history.setOracle([](double m) { return m > 2; });
  const auto answer = [&history](double m) {
    history.add(withoutTypes(std::tuple<double>(m)), {1.0});
    return true;
  };
  history.setOwn(answer);
  answer(1);
  const auto example = simplestCounterExample("isHeavy", history, "MUELLE_RANGE(m, 1, 40)\nbool isHeavy(double m);");
  ASSERT_TRUE(example);
  EXPECT_EQ(exampleSentence(*example), "isHeavy(1): you return true, it is false");
}

TEST(Shrink, KeepsDirectionsOfLengthOne) {
  CallHistory<double(const Vec3&)> history;
  const auto product = [](const Vec3& n) { return n[0] * n[1] * n[2]; };
  const auto square = [](const Vec3& n) { return n[0] * n[1] * n[2] * n[2]; };  // the same along an axis
  const Vec3 first(0.28, -0.576, 0.768), second(0.768, 0.28, -0.576), third = Vec3(1, 2, 4) / std::sqrt(21.0);
  EXPECT_EQ(simplestOf<const Vec3&>(history, product, square, {first, second, third}),
            "f(Vec3(0.48, -0.6, 0.64)): you return -0.117965, it is -0.18432");
}

TEST(Shrink, ReachesTheNumbersOfAVectorOfAnyLength) {
  CallHistory<double(const VecX&)> history;
  const auto sum = [](const VecX& x) { return x.sum(); };
  const auto sumOfSquares = [](const VecX& x) { return x.squaredNorm(); };
  EXPECT_EQ(simplestOf<const VecX&>(history, sum, sumOfSquares, {VecX{{0.421, 3.17}}, VecX{{1.23, 7.77, 0.456}}}),
            "f(VecX{{0, 2}}): you return 4, it is 2");
}

TEST(Shrink, TakesNoLengthForANumberOfAList) {
  CallHistory<double(const std::vector<double>&)> history;
  const auto sum = [](const std::vector<double>& m) { return std::accumulate(m.begin(), m.end(), 0.0); };
  const auto sumOfSquares = [](const std::vector<double>& m) {
    return std::inner_product(m.begin(), m.end(), m.begin(), 0.0);
  };
  EXPECT_EQ(simplestOf<const std::vector<double>&>(history, sum, sumOfSquares, {{0.421, 3.17}, {1.23, 7.77, 0.456}}),
            "f({2}): you return 4, it is 2");
}

TEST(Shrink, KnowsWhatIsForPaper) {
  const auto of = [](const char* argument) { return isForPaper({"f", {argument}, {}, {}}); };
  EXPECT_TRUE(of("Vec3(0.25, -3000, 1e-9)"));
  EXPECT_TRUE(of("{Attachment{Vec3(0, 0, 12), 1, 0}}"));
  EXPECT_FALSE(of("Vec3(0, 1.37, 0)"));
}

TEST(Shrink, HasNothingToSayOfARightFunction) { EXPECT_EQ(simplest(rightForce), "none"); }

}  // namespace
}  // namespace muelle::grader

#include "grader/testing/shrink.h"

#include "grader/report/example_sentence.h"
#include "spring_history.h"

#include <gtest/gtest.h>

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

TEST(Shrink, KnowsWhatIsForPaper) {
  const auto of = [](const char* argument) { return isForPaper({"f", {argument}, {}, {}}); };
  EXPECT_TRUE(of("Vec3(0.25, -3000, 1e-9)"));
  EXPECT_TRUE(of("{Attachment{Vec3(0, 0, 12), 1, 0}}"));
  EXPECT_FALSE(of("Vec3(0, 1.37, 0)"));
}

TEST(Shrink, HasNothingToSayOfARightFunction) { EXPECT_EQ(simplest(rightForce), "none"); }

}  // namespace
}  // namespace muelle::grader

#include "base/file.h"
#include "lab/published/page.h"
#include "lab/published/problem.h"

#include <gtest/gtest.h>
#include <cmath>
#include <set>
#include <string>

namespace muelle::published {
namespace {

class PublishedProblem : public ::testing::TestWithParam<Problem> {};
INSTANTIATE_TEST_SUITE_P(, PublishedProblem, ::testing::ValuesIn(problems()), [](const auto& test) {
  std::string name = test.param.id;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
});

TEST_P(PublishedProblem, ComesOutAsPrintedAndAsTheFormulaHasIt) {
  const Problem& problem = GetParam();
  const std::vector<double> ours = problem.solve();
  ASSERT_EQ(ours.size(), problem.quantities.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Quantity& q = problem.quantities[i];
    EXPECT_NEAR(ours[i], q.exact, q.tolerance * std::abs(q.exact)) << q.what;
    // A rounded value is off by half of its last digit at most; ours besides by its tolerance.
    const double rounding = 0.5 * q.lastDigit() + 1e-12 * std::abs(q.printedValue());
    const double off = std::abs(ours[i] - q.printedValue());
    const double ownError = q.tolerance * std::abs(ours[i]);
    if (q.printedIsOff) {
      EXPECT_GT(std::abs(q.exact - q.printedValue()), rounding) << q.what;
      EXPECT_LT(off, 2e-3 * std::abs(q.exact)) << q.what;  // off by rounding within the source, not by another problem
    } else {
      EXPECT_LE(off, rounding + ownError) << q.what << ": printed " << q.printed << ", ours " << ours[i];
    }
  }
}

TEST(PublishedProblems, AreTenAtLeastEachWithItsSourceAndItsOwnName) {
  std::set<std::string> ids;
  for (const Problem& problem : problems()) {
    EXPECT_TRUE(ids.insert(problem.id).second) << problem.id;
    for (const std::string& text : {problem.title, problem.source, problem.setting}) EXPECT_FALSE(text.empty());
    EXPECT_FALSE(problem.quantities.empty()) << problem.id;
  }
  EXPECT_GE(ids.size(), 10u);
}

TEST(PublishedProblems, TheLastDigitIsReadOffWhatIsPrinted) {
  const auto lastDigit = [](const char* printed) { return Quantity{"", "", printed}.lastDigit(); };
  EXPECT_DOUBLE_EQ(lastDigit("14.48"), 0.01);
  EXPECT_DOUBLE_EQ(lastDigit("3.575e-2"), 1e-5);
  EXPECT_DOUBLE_EQ(lastDigit("90"), 1.0);
  EXPECT_DOUBLE_EQ(lastDigit("-4.596e-4"), 1e-7);
}

TEST(PublishedProblems, ThePageIsUpToDate) {
  EXPECT_EQ(readFile(MUELLE_SOURCE "/docs/published.md"), publishedPage())
      << "write it again: build/bin/muelle-published-page docs/published.md";
}

}  // namespace
}  // namespace muelle::published

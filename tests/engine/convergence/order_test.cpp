/// \file
/// The order of every method of the catalogue, by the errors it makes.

#include "convergence/scenes.h"
#include "engine/analysis/convergence.h"

#include <fmt/format.h>

namespace muelle::engine {
namespace {

using namespace testing;

double error(const State& found, const State& exact) {
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.x.size(); ++i) {
    squares += std::pow(found.x[i] - exact.x[i], 2) + std::pow(found.v[i] - exact.v[i], 2);
  }
  return std::sqrt(squares);
}

/// Steps that a method of this order should be asked to take: from an error of some per cent down to round-off. The
/// ratio shrinks with the order, for three points and more to lie in between.
std::vector<int> stepCounts(int order) {
  const double first = order == 1 ? 200 : order == 2 ? 40 : order <= 5 ? 12 : order == 8 ? 5 : 9;
  const double ratio = order == 1 ? 2.0 : order <= 6 ? 1.6 : order == 8 ? 1.25 : 1.1;
  std::vector<int> counts;
  for (double n = first; counts.size() < 10; n = std::max(ratio * n, n + 1.0)) counts.push_back(static_cast<int>(n));
  return counts;
}

/// `duration` holds a few units of the fastest motion; order 12 has to go further to err by more than round-off.
void expectOrder(const std::string& id, const ExactScene& scene, double duration) {
  const std::unique_ptr<Integrator> method = makeMethod(id);
  const int order = method->info().order;
  if (order > 8) duration *= 5.0;
  const State end = scene.exact(duration);
  std::vector<double> hs, errors;
  std::string table;
  for (const int n : stepCounts(order)) {
    hs.push_back(duration / n);
    errors.push_back(error(run(*method, *scene.system, scene.start, duration / n, n), end));
    table += fmt::format("\n{:6d} {:.3e} {:.3e}", n, hs.back(), errors.back());
  }
  const OrderFit fit = fitOrder(hs, errors, 1e-15);
  ASSERT_TRUE(fit.found) << id << table;
  const std::string what =
      fmt::format("{}: {:.3f} over {} points from {}{}", id, fit.order, fit.count, fit.first, table);
  if (order >= 8) {
    EXPECT_GE(fit.order, order - 0.5) << what;
  } else {
    EXPECT_NEAR(fit.order, order, 0.1) << what;
  }
  ::testing::Test::RecordProperty("order", fmt::format("{:.3f}", fit.order));
}

class Order : public EveryMethod {};
INSTANTIATE_TEST_SUITE_P(Convergence, Order, ::testing::ValuesIn(methodIds()), methodName());

TEST_P(Order, OnTheOscillator) { expectOrder(GetParam(), oscillator(), 5.0); }

TEST_P(Order, OnTheConicalPendulum) { expectOrder(GetParam(), conicalPendulum(), 1.0); }

// The fit itself.
TEST(OrderFit, TakesTheLongestStraightWindowAboveRoundOff) {
  std::vector<double> hs, errors;
  for (int i = 0; i < 12; ++i) {
    const double h = std::pow(2.0, -i);
    hs.push_back(h);
    errors.push_back(h * h * h * (1.0 + 8.0 * h * h) + 1e-9 * (i % 2));
  }
  const OrderFit fit = fitOrder(hs, errors, 1e-9);
  ASSERT_TRUE(fit.found);
  EXPECT_NEAR(fit.order, 3.0, 0.1);
  EXPECT_GE(fit.first, 2);
  EXPECT_EQ(fit.first + fit.count, 8);  // 2^-24 = 6e-8 is below 100 * 1e-9
}

TEST(OrderFit, FindsNothingInNoise) {
  const std::vector<double> hs{1.0, 0.5, 0.25, 0.125}, noise{1e-3, 5e-3, 1e-4, 3e-3};
  EXPECT_FALSE(fitOrder(hs, noise, 1e-16).found);
  EXPECT_FALSE(fitOrder(hs, std::vector<double>{1e-15, 1e-16, 1e-17, 1e-18}, 1e-16).found);
}

TEST(OrderFit, WantsDescendingSteps) {
  const std::vector<double> up{0.1, 0.2, 0.3}, errors{1.0, 2.0, 3.0};
  EXPECT_THROW(fitOrder(up, errors, 0.0), std::invalid_argument);
  EXPECT_THROW(fitOrder(up, std::vector<double>{1.0}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace muelle::engine

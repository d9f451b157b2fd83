#pragma once
#include <algorithm>
#include <limits>

namespace muelle::engine {

/// What the looks at a run's step may cost, in the worth of force evaluations (see extremeModesCost()), and what they
/// have. It is counted, not timed: the same run is looked at in the same way everywhere.
class LookBudget {
 public:
  /// Without a bound.
  LookBudget() = default;
  /// One for a run of so many force evaluations: 5 % of them or 200, whichever is larger.
  static LookBudget ofRun(double evaluations) {
    constexpr double share = 0.05, least = 200.0;
    LookBudget budget;
    budget.left_ = std::max(least, share * evaluations);
    return budget;
  }

  bool covers(double cost) const { return cost <= left_; }
  void spend(double cost) { left_ -= cost; }
  /// The largest dimension of a subspace, from what is wanted down to 4, whose cost(dimension) is covered; 0: none.
  template <class Cost>
  int affordable(int wanted, const Cost& cost) const {
    constexpr int least = 4;
    int dimension = wanted;
    while (dimension >= least && !covers(cost(dimension))) --dimension;
    return dimension >= least ? dimension : 0;
  }

 private:
  double left_ = std::numeric_limits<double>::infinity();
};

}  // namespace muelle::engine

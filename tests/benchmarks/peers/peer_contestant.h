#pragma once
#include "lab/bench/contestant.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace muelle::bench {

/// What a peer's run may cost at most, in evaluations: beyond it is a failure.
inline constexpr long long mostEvaluations = 400'000'000;

/// A peer's method on a problem (PlainProblem or KernelProblem, which outlives it). The unknowns are y = (x, v).
template <class Problem>
class PeerContestant : public Contestant {
 public:
  using Numbers = std::vector<double>;

  PeerContestant(const Problem& problem, std::string library, std::string method)
      : problem_(problem), library_(std::move(library)), method_(std::move(method)) {}

  Row row() const override { return Problem::ofRow; }
  std::string library() const override { return library_; }
  std::string method() const override { return method_; }

  RunCost run(double setting, Path* path) final {
    problem_.evaluations = 0;
    jacobians_ = solves_ = 0;
    RunCost cost;
    cost.failure = solve(setting, path);
    cost.evaluations = problem_.evaluations;
    cost.jacobians = jacobians_;
    cost.solves = solves_;
    return cost;
  }

 protected:
  /// From the start to the end; returns why it did not get there.
  virtual std::string solve(double setting, Path* path) = 0;

  double duration() const { return problem_.scene().duration; }
  long long stepsOf(double h) const { return problem_.scene().stepsOf(h); }
  std::size_t half() const { return problem_.size(); }
  Numbers start() const {
    Numbers y = problem_.startX();
    y.insert(y.end(), problem_.startV().begin(), problem_.startV().end());
    return y;
  }
  void slope(double t, const double* y, double* rate) const {
    std::copy(y + half(), y + 2 * half(), rate);
    problem_.acceleration(t, y, y + half(), rate + half());
  }
  void show(Path* path, double t, const double* x, const double* v) const {
    if (path != nullptr && path->wants(t)) path->see(problem_.point(t, x, v));
  }
  static bool isFinite(const double* y, std::size_t count) {
    return std::all_of(y, y + count, [](double value) { return std::abs(value) < 1e50; });
  }
  static std::string blownUp(double t) { return "not finite at " + std::to_string(t) + " s"; }

  const Problem& problem_;
  long long jacobians_ = 0, solves_ = 0;

 private:
  std::string library_, method_;
};

}  // namespace muelle::bench

#pragma once
#include "engine/integrators/explicit/engines/stage_kernels.h"
#include "engine/integrators/explicit/tableaus.h"

#include <array>
#include <memory>
#include <vector>

namespace muelle::engine {

/// Weights of the stages that enter a sum, zeros left out: of positions, of velocities, of up to two estimates. A copy
/// shares what does not depend on the step, and has yet to be told the step and where the accelerations are.
class StageSum {
 public:
  StageSum() = default;
  /// \param wx weights of positions (h^2 a_j), wv of velocities (h a_j); the shorter is filled up with zeros
  /// \param ex, ev the same of estimates
  StageSum(const Coefficients& wx, const Coefficients& wv, const std::vector<Coefficients>& ex = {},
           const std::vector<Coefficients>& ev = {});
  StageSum(const StageSum& other) : exact_(other.exact_) { begin(); }
  StageSum& operator=(const StageSum& other) {
    if (this == &other) return *this;
    exact_ = other.exact_;
    begin();
    return *this;
  }

  /// Says where the accelerations are now.
  void readFrom(const std::vector<double*>& accelerations) {
    for (std::size_t j = 0; j < terms_.count; ++j) terms_.a[j] = accelerations[exact_->stages[j]];
  }
  /// For steps of h [s] from now on.
  void scale(double h);
  const StageTerms& terms() const { return terms_; }
  std::size_t estimates() const { return exact_->estimates; }
  const StageEstimate* estimateWeights() const { return weights_; }

 private:
  static constexpr std::size_t mostEstimates = 2, mostRows = 2 + 2 * mostEstimates;

  /// What holds for every step.
  struct Exact {
    std::size_t estimates = 0;
    std::size_t both = 0, positions = 0, velocities = 0;  ///< as in StageTerms
    std::vector<std::size_t> stages;
    std::vector<double> weights;  ///< all wx, all wv, and ex, ev of each estimate
  };
  static std::shared_ptr<const Exact> exactOf(const Coefficients& wx, const Coefficients& wv,
                                              const std::vector<Coefficients>& ex, const std::vector<Coefficients>& ev);
  void begin();

  std::shared_ptr<const Exact> exact_;
  StageTerms terms_;
  StageEstimate weights_[mostEstimates] = {};
  std::array<double, mostRows * mostStageTerms> scaled_;  ///< by h^2, h, h^2, h ...; nothing before scale()
};

}  // namespace muelle::engine

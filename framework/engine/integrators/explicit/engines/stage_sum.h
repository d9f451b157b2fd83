#pragma once
#include "engine/integrators/explicit/engines/stage_kernels.h"
#include "engine/integrators/explicit/tableaus.h"

#include <vector>

namespace muelle::engine {

/// Weights of the stages that enter a sum, zeros left out: of positions, of velocities, of up to two estimates.
class StageSum {
 public:
  StageSum() = default;
  /// \param wx weights of positions (h^2 a_j), wv of velocities (h a_j); the shorter is filled up with zeros
  /// \param ex, ev the same of estimates
  StageSum(const Coefficients& wx, const Coefficients& wv, const std::vector<Coefficients>& ex = {},
           const std::vector<Coefficients>& ev = {});
  StageSum(StageSum&&) = default;  // no copy: terms_ points into vectors
  StageSum& operator=(StageSum&&) = default;

  /// Says where the accelerations are now.
  void readFrom(const std::vector<double*>& accelerations) {
    for (std::size_t j = 0; j < terms_.count; ++j) terms_.a[j] = accelerations[stages_[j]];
  }
  /// For steps of h [s] from now on.
  void scale(double h);
  const StageTerms& terms() const { return terms_; }
  std::size_t estimates() const { return estimates_; }
  const StageEstimate* estimateWeights() const { return weights_; }

 private:
  std::size_t estimates_ = 0;
  StageTerms terms_;
  StageEstimate weights_[2] = {};
  std::vector<std::size_t> stages_;
  std::vector<double> unscaled_;  ///< all wx, all wv, and ex, ev of each estimate
  std::vector<double> scaled_;    ///< by h^2, h, h^2, h ...
};

}  // namespace muelle::engine

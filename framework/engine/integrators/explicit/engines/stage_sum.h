#pragma once
#include "engine/integrators/explicit/engines/stage_kernels.h"
#include "engine/integrators/explicit/tableaus.h"

#include <array>
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

  /// With where the accelerations are now.
  StageTerms over(const std::vector<double*>& accelerations) const {
    StageTerms terms;
    terms.count = stages_.size();
    for (std::size_t j = 0; j < terms.count; ++j) terms.a[j] = accelerations[stages_[j]];
    terms.wx = wx_.data();
    terms.wv = wv_.data();
    return terms;
  }
  std::size_t estimates() const { return estimates_.size(); }
  std::array<StageEstimate, 2> estimatesOver() const;

 private:
  struct Estimate {
    std::vector<double> ex, ev;
  };
  std::vector<std::size_t> stages_;
  std::vector<double> wx_, wv_;
  std::vector<Estimate> estimates_;
};

}  // namespace muelle::engine

#include "engine/integrators/explicit/engines/stage_sum.h"

#include <algorithm>
#include <stdexcept>

namespace muelle::engine {

namespace {

long double at(const Coefficients& weights, std::size_t j) { return j < weights.size() ? weights[j] : 0.0L; }

}  // namespace

StageSum::StageSum(const Coefficients& wx, const Coefficients& wv, const std::vector<Coefficients>& ex,
                   const std::vector<Coefficients>& ev)
    : estimates_(ex.size()) {
  std::size_t stages = std::max(wx.size(), wv.size());
  for (const Coefficients& weights : ev) stages = std::max(stages, weights.size());
  for (std::size_t j = 0; j < stages; ++j) {
    bool enters = at(wx, j) != 0.0L || at(wv, j) != 0.0L;
    for (std::size_t e = 0; e < ex.size(); ++e) enters = enters || at(ex[e], j) != 0.0L || at(ev[e], j) != 0.0L;
    // A kernel has one term at least.
    if (!enters && !(stages_.empty() && j + 1 == stages)) continue;
    stages_.push_back(j);
    wx_.push_back(static_cast<double>(at(wx, j)));
    wv_.push_back(static_cast<double>(at(wv, j)));
    for (std::size_t e = 0; e < ex.size(); ++e) {
      estimates_[e].ex.push_back(static_cast<double>(at(ex[e], j)));
      estimates_[e].ev.push_back(static_cast<double>(at(ev[e], j)));
    }
  }
  if (stages_.size() > mostStageTerms) throw std::logic_error("StageSum: more stages than the kernels take");
}

std::array<StageEstimate, 2> StageSum::estimatesOver() const {
  std::array<StageEstimate, 2> all{};
  for (std::size_t e = 0; e < estimates_.size(); ++e) all[e] = {estimates_[e].ex.data(), estimates_[e].ev.data()};
  return all;
}

}  // namespace muelle::engine

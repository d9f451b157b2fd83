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
  std::vector<const Coefficients*> all{&wx, &wv};
  for (std::size_t e = 0; e < estimates_; ++e) all.insert(all.end(), {&ex[e], &ev[e]});
  std::size_t most = 0;
  for (const Coefficients* weights : all) most = std::max(most, weights->size());
  const auto take = [&](bool inPositions, bool inVelocities) {
    const std::size_t before = stages_.size();
    for (std::size_t j = 0; j < most; ++j) {
      if ((at(wx, j) != 0.0L) != inPositions || (at(wv, j) != 0.0L) != inVelocities) continue;
      if (std::ranges::any_of(all, [j](const Coefficients* w) { return at(*w, j) != 0.0L; })) stages_.push_back(j);
    }
    return stages_.size() - before;
  };
  terms_.both = take(true, true);
  terms_.positions = take(true, false);
  terms_.velocities = take(false, true);
  take(false, false);
  terms_.count = stages_.size();
  if (terms_.count > mostStageTerms) throw std::logic_error("StageSum: more stages than the kernels take");
  for (const Coefficients* weights : all) {
    std::vector<double>& numbers = unscaled_.emplace_back();
    for (const std::size_t j : stages_) numbers.push_back(static_cast<double>(at(*weights, j)));
  }
  scaled_ = unscaled_;
  terms_.wx = scaled_[0].data();
  terms_.wv = scaled_[1].data();
  for (std::size_t e = 0; e < estimates_; ++e) {
    weights_[e] = {scaled_[2 + 2 * e].data(), scaled_[3 + 2 * e].data()};
  }
}

void StageSum::scale(double h) {
  for (std::size_t k = 0; k < unscaled_.size(); ++k) {
    const double factor = k % 2 == 0 ? h * h : h;
    std::ranges::transform(unscaled_[k], scaled_[k].begin(), [factor](double weight) { return factor * weight; });
  }
}

}  // namespace muelle::engine

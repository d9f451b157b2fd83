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
  stages_.reserve(most);
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
  unscaled_.reserve(all.size() * terms_.count);
  for (const Coefficients* weights : all) {
    for (const std::size_t j : stages_) unscaled_.push_back(static_cast<double>(at(*weights, j)));
  }
  scaled_ = unscaled_;
  const auto row = [this](std::size_t k) { return scaled_.data() + k * terms_.count; };
  terms_.wx = row(0);
  terms_.wv = row(1);
  for (std::size_t e = 0; e < estimates_; ++e) weights_[e] = {row(2 + 2 * e), row(3 + 2 * e)};
}

void StageSum::scale(double h) {
  const std::size_t count = terms_.count;
  for (std::size_t i = 0; i < unscaled_.size(); i += 2 * count) {
    for (std::size_t j = i; j < i + count; ++j) scaled_[j] = h * h * unscaled_[j];
    for (std::size_t j = i + count; j < i + 2 * count; ++j) scaled_[j] = h * unscaled_[j];
  }
}

}  // namespace muelle::engine

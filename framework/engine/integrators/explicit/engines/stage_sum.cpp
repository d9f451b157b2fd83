#include "engine/integrators/explicit/engines/stage_sum.h"

#include <algorithm>
#include <stdexcept>

namespace muelle::engine {

namespace {

long double at(const Coefficients& weights, std::size_t j) { return j < weights.size() ? weights[j] : 0.0L; }

}  // namespace

StageSum::StageSum(const Coefficients& wx, const Coefficients& wv, const std::vector<Coefficients>& ex,
                   const std::vector<Coefficients>& ev)
    : exact_(exactOf(wx, wv, ex, ev)) {
  begin();
}

std::shared_ptr<const StageSum::Exact> StageSum::exactOf(const Coefficients& wx, const Coefficients& wv,
                                                         const std::vector<Coefficients>& ex,
                                                         const std::vector<Coefficients>& ev) {
  auto exact = std::make_shared<Exact>();
  exact->estimates = ex.size();
  std::vector<const Coefficients*> all{&wx, &wv};
  for (std::size_t e = 0; e < ex.size(); ++e) all.insert(all.end(), {&ex[e], &ev[e]});
  std::size_t most = 0;
  for (const Coefficients* weights : all) most = std::max(most, weights->size());
  std::vector<std::size_t>& stages = exact->stages;
  stages.reserve(most);
  const auto take = [&](bool inPositions, bool inVelocities) {
    const std::size_t before = stages.size();
    for (std::size_t j = 0; j < most; ++j) {
      if ((at(wx, j) != 0.0L) != inPositions || (at(wv, j) != 0.0L) != inVelocities) continue;
      if (std::ranges::any_of(all, [j](const Coefficients* w) { return at(*w, j) != 0.0L; })) stages.push_back(j);
    }
    return stages.size() - before;
  };
  exact->both = take(true, true);
  exact->positions = take(true, false);
  exact->velocities = take(false, true);
  take(false, false);
  if (stages.size() > mostStageTerms || ex.size() > mostEstimates) {
    throw std::logic_error("StageSum: more stages or estimates than the kernels take");
  }
  exact->weights.reserve(all.size() * stages.size());
  for (const Coefficients* weights : all) {
    for (const std::size_t j : stages) exact->weights.push_back(static_cast<double>(at(*weights, j)));
  }
  return exact;
}

/// Leads all rows into the own numbers.
void StageSum::begin() {
  if (!exact_) return;
  terms_.both = exact_->both;
  terms_.positions = exact_->positions;
  terms_.velocities = exact_->velocities;
  terms_.count = exact_->stages.size();
  const auto row = [this](std::size_t k) { return scaled_.data() + k * terms_.count; };
  terms_.wx = row(0);
  terms_.wv = row(1);
  for (std::size_t e = 0; e < exact_->estimates; ++e) weights_[e] = {row(2 + 2 * e), row(3 + 2 * e)};
}

void StageSum::scale(double h) {
  const std::size_t count = terms_.count;
  const std::vector<double>& exact = exact_->weights;
  for (std::size_t i = 0; i < exact.size(); i += 2 * count) {
    for (std::size_t j = i; j < i + count; ++j) scaled_[j] = h * h * exact[j];
    for (std::size_t j = i + count; j < i + 2 * count; ++j) scaled_[j] = h * exact[j];
  }
}

}  // namespace muelle::engine

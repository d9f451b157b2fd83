#include "engine/integrators/explicit/engines/combination.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::engine {

void Combination::add(double weight, const double* k) {
  if (weight == 0.0) return;
  if (count_ == terms_.size()) throw std::logic_error("Combination: more stages than the table holds");
  terms_[count_++] = {weight, k};
}

void Combination::block(std::size_t begin, std::size_t count, double* sum) const {
  std::fill(sum, sum + count, 0.0);
  for (std::size_t j = 0; j < count_; ++j) {
    const double weight = terms_[j].weight;
    const double* k = terms_[j].k + begin;
    for (std::size_t i = 0; i < count; ++i) sum[i] += weight * k[i];
  }
}

void Combination::addTo(In base, double scale, Out out) const {
  std::array<double, blockSize> sum;
  for (std::size_t begin = 0; begin < base.size(); begin += blockSize) {
    const std::size_t count = std::min(blockSize, base.size() - begin);
    block(begin, count, sum.data());
    for (std::size_t i = 0; i < count; ++i) out[begin + i] = base[begin + i] + scale * sum[i];
  }
}

void Combination::assignTo(double scale, Out out) const {
  std::array<double, blockSize> sum;
  for (std::size_t begin = 0; begin < out.size(); begin += blockSize) {
    const std::size_t count = std::min(blockSize, out.size() - begin);
    block(begin, count, sum.data());
    for (std::size_t i = 0; i < count; ++i) out[begin + i] = scale * sum[i];
  }
}

double Combination::largestError(double scale, In from, In to, double allowed) const {
  std::array<double, blockSize> sum;
  double largest = 0.0;
  for (std::size_t begin = 0; begin < from.size(); begin += blockSize) {
    const std::size_t count = std::min(blockSize, from.size() - begin);
    block(begin, count, sum.data());
    for (std::size_t i = 0; i < count; ++i) {
      const double ratio = errorRatio(scale * sum[i], from[begin + i], to[begin + i], allowed);
      largest = ratio > largest || std::isnan(ratio) ? ratio : largest;
      if (std::isnan(largest)) return largest;
    }
  }
  return largest;
}

int firstNotFinite(In values) {
  // The sum first: it is one pass without a branch, and nearly always suffices.
  double zeros = 0.0;
  for (const double value : values) zeros += 0.0 * value;
  if (zeros == 0.0) return -1;
  const auto at = std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
  return static_cast<int>(at - values.begin());
}

StepResult finiteOrFailure(const DynamicalSystem& system, const State& from, const State& to, double error) {
  const int position = firstNotFinite(to.x);
  const int velocity = position < 0 ? firstNotFinite(to.v) : -1;
  const auto failure = [&](std::string_view what) {
    return StepResult{.done = false,
                      .error = error,
                      .failure = fmt::format("{} is not finite after a step of {:g} s from t = {:g} s: the step is "
                                             "beyond the method's stability, or the force is not finite",
                                             what, to.t - from.t, from.t)};
  };
  if (position >= 0) return failure("the position of " + laneName(system, position));
  if (velocity >= 0) return failure("the velocity of " + laneName(system, velocity));
  if (!std::isfinite(error)) return failure("the estimated error");
  return {.done = true, .error = error, .failure = {}};
}

}  // namespace muelle::engine

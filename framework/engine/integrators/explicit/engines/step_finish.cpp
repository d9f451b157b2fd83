#include "engine/integrators/explicit/engines/step_finish.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::engine {

double largestErrorRatio(In estimate, In from, In to, double allowed) {
  double largest = 0.0;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    largest = larger(errorRatio(estimate[i], from[i], to[i], allowed), largest);
    if (std::isnan(largest)) return largest;
  }
  return largest;
}

void takeSizes(const State& from, State& to) {
  to.x.resize(from.x.size());
  to.v.resize(from.v.size());
  to.z = from.z;
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

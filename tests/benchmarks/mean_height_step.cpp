/// \file
/// Hard case H05 at n = 100000: how many force evaluations the time of an implicit step is worth, both measured in
/// turns in one run. The bar is 20.

#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "lab/hard_cases/models.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <vector>

namespace {

using namespace muelle;

template <class Work>
double seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure(const engine::ModelSystem& system, const char* id) {
  const State start = system.initialState();
  const auto method = engine::makeMethod(id);
  method->prepare(system, {});
  State end = start;
  std::vector<double> f(start.x.size()), ratios, steps;
  constexpr int evaluations = 20;
  for (int i = 0; i < 11; ++i) {
    const double step = seconds([&] { method->step(system, start, 0.01, end); });
    const double forces = seconds([&] {
      for (int k = 0; k < evaluations; ++k) system.force(0.0, start.x, start.v, start.z, f);
    });
    if (i == 0) continue;  // allocates
    steps.push_back(step);
    ratios.push_back(step * evaluations / forces);
  }
  fmt::print("{:<20} {:5.1f} force evaluations a step (least {:.1f}, most {:.1f}); {:.1f} ms; work: {} evaluations\n",
             id, median(ratios), *std::min_element(ratios.begin(), ratios.end()),
             *std::max_element(ratios.begin(), ratios.end()), 1e3 * median(steps),
             method->work().forceEvaluations / 11);
}

}  // namespace

int main() {
  const auto system = engine::build(hard_cases::meanHeight(100'000));
  for (const char* id : {"backward_euler", "implicit_midpoint"}) measure(*system, id);
}

#include "lab/hard_cases/variant.h"

#include "lab/hard_cases/variants/families.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muelle::hard_cases {

double Steps::of(const engine::MethodInfo& method) const {
  if (method.implicit) return !method.iterative ? implicit : iterative > 0.0 ? iterative : first;
  return method.order >= 8 ? eighth : method.order >= 4 ? fourth : first;
}

double Steps::toleranceOf(const engine::MethodInfo& method) const {
  return method.order == 2 ? std::pow(tolerance, 2.0 / 3.0) : tolerance;
}

double amplitudeFactor(double ratio) {
  constexpr double most = 1e6;
  return ratio > 0.0 ? std::min(most, std::max(ratio, 1.0 / ratio)) : most;
}

void completeFacts(Variant& variant) {
  if (!variant.linear && !variant.modes.empty() && variant.extent == 0.0) variant.extent = extentOf(variant);
  if (variant.sensitive && !variant.sensitivity) variant.sensitivity = sensitivityOf(variant);
}

std::vector<Variant> allVariants() {
  std::vector<Variant> all;
  for (const auto family : {oscillatorVariants, bodyVariants, chainVariants, singularVariants, clothVariants,
                            contactVariants, pulseAndDragVariants}) {
    std::ranges::move(family(), std::back_inserter(all));
  }
  return all;
}

}  // namespace muelle::hard_cases

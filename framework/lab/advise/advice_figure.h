#pragma once
#include "harness/figure.h"
#include "lab/advise/advice.h"

namespace muelle::lab {

/// Error against time on one slide: the methods that were run, each at the settings that it was tried at, and the way
/// from the whole model to the advised one, its parts switched off one by one; beside it what leaving out each of the
/// parts that are kept would do.
Figure figureOf(const engine::Scene& scene, const Advice& advice);

}  // namespace muelle::lab

#pragma once
#include "lab/run/deviation.h"
#include "lab/run/run_scene.h"

namespace muelle::lab {

/// Runs the scene again with half the step (an adaptive method: a tenth of the tolerance) and compares what moved, at
/// the same times. The order is not believed but seen: a run with twice the step has to differ as the method's order
/// says; where it does not, runs with a quarter and an eighth of the step (a hundredth and a thousandth of the
/// tolerance), down to a 64th where such runs are short, say how fast the runs approach each other. Where they do not,
/// do so faster than any error shrinks, or do not move about as far as each other, there is no estimate. Neither is
/// there one where the runs share a mistake: see ErrorEstimate::failure.
ErrorEstimate estimateError(const engine::Scene& scene, const SceneRun& run, const std::string& label = {});

}  // namespace muelle::lab

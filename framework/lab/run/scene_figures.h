#pragma once
#include "harness/figure.h"
#include "lab/run/run_scene.h"

#include <vector>

namespace muelle::lab {

/// The figures of a run: NAME_energy (kinetic, potential, total; the potential energy from its least, since heights
/// have no zero), NAME_outputs (a panel for each output that is a number), NAME_shape (the springs at the start and at
/// the end, seen in the scene's view, nodes as dots where there are few; in 1D the positions over time) and NAME_path
/// for the outputs that are paths, with a mark at their starts. Where a run explodes the axes show what came before,
/// and the curves say that they leave the picture.
std::vector<Figure> figuresOf(const engine::Scene& scene, const SceneRun& run);

}  // namespace muelle::lab

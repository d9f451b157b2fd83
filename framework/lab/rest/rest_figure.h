#pragma once
#include "harness/figure.h"
#include "lab/rest/rest_scene.h"

namespace muelle::lab {

/// The figure "rest", a slide: the shape in the scene's view with its springs by what they do (pull, push, neither)
/// over the start, and beside it the tension of each spring. In 1D the positions of the nodes take the shape's place.
Figure figureOf(const engine::Scene& scene, const SceneAtRest& rest);

}  // namespace muelle::lab

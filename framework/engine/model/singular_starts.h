#pragma once
#include "engine/model/model.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// Where a model starts at a point at which its energy has no gradient: nodes in one place that a spring of positive
/// rest length joins, a straight angle in 3D that wants to be bent (theta0 above 0), an angle folded back onto itself,
/// a node at the centre of a ball. The force there has no direction and is taken as 0: the start may look like rest,
/// and the least disturbance decides where it goes. A sentence each; empty when there is none.
std::vector<std::string> singularStarts(const Model& model);

}  // namespace muelle::engine

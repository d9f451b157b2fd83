#pragma once
#include "harness/types.h"

namespace muelle::engine {

/// Replaces the symmetric matrix of an element by the nearest positive semidefinite one: its negative eigenvalues
/// become 0. The one place for this, because Eigen's eigenvalues take long to compile for each size.
void keepPositivePart(Eigen::Ref<Eigen::MatrixXd> K);

}  // namespace muelle::engine

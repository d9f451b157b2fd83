#pragma once
#include "engine/statics/equilibrium.h"

#include <gtest/gtest.h>

namespace muelle::engine {

/// Every test ends here: the forces sum to 0 at every node, to what round-off of the positions leaves.
inline void expectBalanced(const StaticResult& result) {
  EXPECT_TRUE(result.converged) << result.message;
  EXPECT_LE(result.residual, 100.0 * result.roundOff + 1e-14) << result.message;
}

}  // namespace muelle::engine

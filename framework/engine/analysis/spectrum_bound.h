#pragma once
#include "engine/analysis/linearised_system.h"

#include <optional>

namespace muelle::engine {

/// What no mode of a linearised system exceeds: whatever y is, |y* K y| <= stiffness, |y* D y| (without the drag) <=
/// damping and the drag's part <= drag, each in parts of y* M y (see Mode).
struct SpectrumBound {
  double stiffness = 0.0;  ///< [1/s^2]
  double damping = 0.0;    ///< [1/s]
  double drag = 0.0;       ///< [1/s]
  int unknown = -1;        ///< where the stiffness (without any: the damping) is at its bound
};

/// One pass over the blocks of the matrices, those of a node and of two nodes that share a spring, and some over the
/// numbers that it leaves, one a block. Nothing where the system has no matrices.
///
/// For y with parts y_a at the nodes, |y* K y| <= sum_ab |y_a| s_ab |y_b| with s_ab = (|K_ab| + |K_ba|) / 2, norms of
/// blocks. So with m_a the mass of node a the quotient is at most the largest eigenvalue of s_ab / m_a, a matrix
/// without negative entries, and that is at most max_a sum_b s_ab d_b / (m_a d_a) for any positive d (Collatz 1942).
/// With d = 1 that is Gershgorin's bound by blocks, for springs 2 sum k / m; a few steps of the power method make d
/// better, and the bound stays one at each. After one step it is exact for a single spring, k (1/m_a + 1/m_b).
std::optional<SpectrumBound> spectrumBound(const LinearisedSystem& system);

/// In the worth of force evaluations, the matrices not counted (measured as extremeModesCost() was).
inline constexpr double spectrumBoundCost = 20.0;

}  // namespace muelle::engine

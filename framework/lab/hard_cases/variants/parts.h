#pragma once
/// \file
/// What the variants of the hard cases have in common.

#include "lab/hard_cases/references.h"
#include "lab/hard_cases/variant.h"

#include <cmath>

namespace muelle::hard_cases {

/// The reference values of a case as a point [m]; a component without a name is 0.
inline Vec3 place(const std::string& id, const std::string& x, const std::string& y, const std::string& z) {
  return {x.empty() ? 0.0 : reference(id, x), y.empty() ? 0.0 : reference(id, y), z.empty() ? 0.0 : reference(id, z)};
}

/// Distance of a node from its reference at the end [m].
inline std::function<double(const Finished&)> nodeAt(int node, const Vec3& expected) {
  return [=](const Finished& end) { return (end.x(node) - expected).norm(); };
}
/// The same along the line of a 1D scene.
inline std::function<double(const Finished&)> coordinate(int node, double expected) {
  return [=](const Finished& end) { return std::abs(end.x(node)[0] - expected); };
}

/// An undamped mode of frequency omega [1/s] and amplitude [m].
inline Mode mode(double omega, double amplitude) { return {.stiffness = omega * omega, .amplitude = amplitude}; }

}  // namespace muelle::hard_cases

#pragma once
#include "engine/model/model.h"

namespace muelle::engine {

// Motions as a displacement from where a node starts, 0 until `from`.

/// `d` along 10 s^3 - 15 s^4 + 6 s^5, s = (t - from) / (to - from): velocity and acceleration begin and end at 0.
Motion smoothStroke(const Vec3& d, double from, double to);
/// `amplitude` sin(2 pi frequency (t - from)) until `to`, then it stays where it is.
Motion oscillation(const Vec3& amplitude, double frequency, double from, double to);
/// At velocity `v` between `from` and `to`, then it stays where it is.
Motion steadyMotion(const Vec3& v, double from, double to);

/// The motion of a node that starts at x and is displaced as `about` says.
Motion startingAt(const Vec3& x, const Motion& about);

/// F on each of the nodes for from <= t < to (times the sine of 2 pi frequency (t - from) when a frequency is given);
/// `from` and `to`, where they are no limits of time itself, are its declared times.
ModelExternalForce externalForce(std::vector<int> nodes, const Vec3& F, double from, double to, double frequency);

}  // namespace muelle::engine

#pragma once
/// \file
/// What the scenes of the hard cases are put together from.

#include "engine/model/model.h"

namespace muelle::hard_cases {

using engine::Model;
using engine::ModelNode;
using engine::ModelSpring;
using engine::Obstacle;

inline constexpr double g = 9.81;  ///< [m/s^2]

/// A free node at x [m] of mass m [kg] with velocity v [m/s].
inline ModelNode at(const Vec3& x, double m = 1.0, const Vec3& v = Vec3::Zero()) { return {.x = x, .v = v, .m = m}; }
/// A pinned node.
inline ModelNode anchor(const Vec3& x) { return {.x = x, .pinned = true}; }

/// Nothing, in the x-z plane under gravity.
inline Model inPlane() {
  Model model;
  model.dimension = 2;
  model.gravity = Vec3(0, 0, -g);
  return model;
}

/// Nothing, on a line whose coordinate points up where there is gravity [m/s^2].
inline Model onLine(double gravity = 0.0) {
  Model model;
  model.dimension = 1;
  model.gravity = Vec3(-gravity, 0, 0);
  return model;
}

/// The ground at 0 of a scene on a line; k [N/m], d [kg/s].
inline Obstacle floorOfLine(double k, double d) {
  Obstacle ground;
  ground.normal = Vec3::UnitX();
  ground.material.k = k;
  ground.material.d = d;
  return ground;
}

}  // namespace muelle::hard_cases

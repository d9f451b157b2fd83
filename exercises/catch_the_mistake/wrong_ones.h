#pragma once
/// \file
/// Implementations to try your tests on, all of them very wrong. Right ones are those that you have written yourself
/// for the earlier exercises.

#include "catch_the_mistake.h"
#include "course/testing/test_function.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// Something wrong, and what is wrong about it.
template <class Implementation>
struct Wrong {
  std::string name;
  Implementation implementation;
};

/// An energy with something that ought to be its gradient.
struct EnergyWithGradient {
  SpringEnergy springEnergy;
  EnergyGradient energyGradient;
};

inline std::vector<Wrong<SpringForce>> wrongForces() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {{"no force at all", [](double, double, double, double) { return 0.0; }},
          {"the same everywhere", [](double, double, double k, double L0) { return k * L0; }},
          {"towards the origin", [](double xa, double, double k, double) { return -k * xa; }},
          {"no number when compressed",
           [=](double xa, double xb, double k, double L0) { return std::abs(xa - xb) < L0 ? nan : k * xb - k * xa; }},
          {"throws an exception", [](double, double, double, double) -> double {
             throw muelle::ThrownToAsker("this implementation throws");
           }}};
}

inline std::vector<Wrong<EnergyWithGradient>> wrongGradients() {
  const SpringEnergy none = [](const Vec6&, double, double) { return 0.0; };
  const EnergyGradient flat = [](const Vec6&, double, double) { return Vec6(Vec6::Zero()); };
  const SpringEnergy same = [](const Vec6&, double k, double L0) { return k * L0; };
  const SpringEnergy toOrigin = [](const Vec6& x, double k, double) { return k * x.dot(x); };
  const EnergyGradient fromOrigin = [](const Vec6& x, double k, double) { return Vec6(2 * k * x); };
  const EnergyGradient fails = [](const Vec6&, double, double) -> Vec6 {
    throw muelle::ThrownToAsker("this implementation throws");
  };
  return {{"zero, with its gradient", {none, flat}},
          {"the same everywhere, with its gradient", {same, flat}},
          {"a spring to the origin, with its gradient", {toOrigin, fromOrigin}},
          {"a gradient of something else", {same, fromOrigin}},
          {"a gradient that throws", {toOrigin, fails}}};
}

inline std::vector<Wrong<ProjectedDamping>> wrongDampings() {
  using Points = const Vec3&;
  return {{"no force at all", [](Points, Points, Points, Points, double) { return Vec3(Vec3::Zero()); }},
          {"always upwards", [](Points, Points, Points, Points, double d) { return Vec3(0, 0, d); }},
          {"along the velocity of b", [](Points, Points, Points, Points vb, double d) { return Vec3(d * vb); }},
          {"a spring, no damper", [](Points xa, Points xb, Points, Points, double d) { return Vec3(d * xb - d * xa); }},
          {"throws an exception", [](Points, Points, Points, Points, double) -> Vec3 {
             throw muelle::ThrownToAsker("this implementation throws");
           }}};
}

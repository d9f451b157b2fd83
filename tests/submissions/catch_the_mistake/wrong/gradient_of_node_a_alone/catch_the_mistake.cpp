// loses: GradientValues, GradientEdges; misconception: none
// Looks at the first three components of the gradient only, because b has the opposite anyway.
#include "catch_the_mistake.h"

namespace {

const double stiffnesses[] = {1e-3, 12.7, 1e9};
const double restLengths[] = {0, 0.73, 1000};

// NaN is not near anything.
bool isNear(double got, double expected, double tolerance) { return std::abs(got - expected) <= tolerance; }

template <class Vector>
bool isNear(const Vector& got, const Vector& expected, double tolerance) {
  for (int i = 0; i < got.size(); ++i) {
    if (!isNear(got[i], expected[i], tolerance)) return false;
  }
  return true;
}

template <class Vector>
bool isZero(const Vector& got) {
  return isNear(got, Vector(Vector::Zero()), 0);
}

const Vec3 directions[] = {Vec3(0.36, -0.48, 0.8), Vec3(-2, 3, 6) / 7, Vec3(-0.6, -0.64, -0.48),
                           Vec3(1, 0, 0),          Vec3(0, -1, 0),     Vec3(0, 0, 1)};

Vec6 stacked(const Vec3& xa, const Vec3& xb) {
  Vec6 x;
  x << xa, xb;
  return x;
}

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  const auto isRightAt = [&](double xa, double xb, double k, double L0) {
    const double L = std::abs(xb - xa), direction = xb > xa ? 1 : -1;  // towards b
    return isNear(springForceOnA(xa, xb, k, L0), k * (L - L0) * direction, 1e-7 * k * (L + L0));
  };
  const double lines[][2] = {{0.3, 2.9},    {2.9, 0.3},    {-1.7, 0.4}, {0.4, -1.7}, {-5.1, -4.8}, {-4.8, -5.1},
                             {700, -999.5}, {-1000, 1000}, {0, 0.137},  {0, -731.4}, {812.25, 0}};
  try {
    for (const auto& line : lines) {
      for (double k : stiffnesses) {
        for (double L0 : restLengths) {
          if (!isRightAt(line[0], line[1], k, L0)) return false;
        }
      }
    }
    for (int exponent = 1; exponent <= 100; ++exponent) {
      const double L = 1.1 * std::pow(10, -exponent);
      const double sign = exponent % 2 == 0 ? 1 : -1;
      if (!isRightAt(0, sign * L, 31.7, 0.83)) return false;
      if (exponent % 3 == 0 && !isRightAt(sign * L, 0, 31.7, 0.83)) return false;
    }
    for (double x : {0.0, 1.37, -1000.0, 512.0}) {
      for (double L0 : restLengths) {
        if (!(springForceOnA(x, x, 12.7, L0) == 0)) return false;
      }
    }
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  const auto areRightAt = [&](const Vec3& xa, const Vec3& xb, double k, double L0) {
    const Vec3 d = xa - xb;
    const double L = d.norm(), whole = k * (L + L0);
    const Vec3 onA = k * (L - L0) * d / L;
    const Vec6 x = stacked(xa, xb);
    return isNear(springEnergy(x, k, L0), k / 2 * (L - L0) * (L - L0), 1e-7 * whole * (L + L0)) &&
           isNear(Vec3(energyGradient(x, k, L0).head<3>()), onA, 1e-7 * whole);
  };
  try {
    for (const Vec3& u : directions) {
      for (double L : {0.31, 1.9, 640.0}) {
        for (double L0 : restLengths) {
          const double k = stiffnesses[&u - directions == 1 ? 0 : &u - directions == 2 ? 2 : 1];
          const Vec3 xa(1.25, -3.5, 0.75);
          if (!areRightAt(xa, xa + L * u, k, L0)) return false;
        }
      }
    }
    for (int exponent = 1; exponent <= 100; ++exponent) {
      const Vec3 d = 1.1 * std::pow(10, -exponent) * directions[exponent % 3];
      if (!areRightAt(d, Vec3::Zero(), 31.7, 0.83)) return false;
    }
    const Vec3 places[] = {Vec3::Zero(), Vec3(1.37, -2.2, 3.1), Vec3(-1000, 1000, 512)};
    for (const Vec3& place : places) {
      for (double L0 : restLengths) {
        const Vec6 x = stacked(place, place);
        if (!isNear(springEnergy(x, 12.7, L0), 12.7 / 2 * L0 * L0, 1e-7 * 12.7 * L0 * L0)) return false;
        if (!isZero(Vec3(energyGradient(x, 12.7, L0).head<3>()))) return false;
      }
    }
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  const auto isRightAt = [&](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
    const Vec3 u = (xb - xa) / (xb - xa).norm();
    const Vec3 expected = -d * (va - vb).dot(u) * u;
    return isNear(projectedDamping(xa, xb, va, vb, d), expected, 1e-7 * d * (va.norm() + vb.norm()));
  };
  const Vec3 none = Vec3::Zero(), some(1.3, -0.7, 2.1), other(-3.1, 1.9, 0.6), fast(990, -870, 940);
  const Vec3 pairs[][2] = {{some, other}, {other, some}, {some, none},
                           {none, some},  {some, some},  {fast, other},
                           {-fast, fast}, {none, none},  {1e-60 * some, 1e-60 * other}};
  try {
    for (const Vec3& u : directions) {
      for (double L : {0.31, 640.0}) {
        for (const auto& [va, vb] : pairs) {
          const Vec3 xa(1.25, -3.5, 0.75);
          if (!isRightAt(xa, xa + L * u, va, vb, L < 1 ? 2.7 : 1e6)) return false;
        }
      }
    }
    if (!isZero(projectedDamping(some, other, other, some, 0))) return false;
    for (int exponent = 1; exponent <= 100; ++exponent) {
      const Vec3 d = 1.1 * std::pow(10, -exponent) * directions[exponent % 3];
      if (!isRightAt(d, none, some, other, 2.7)) return false;
      if (!isRightAt(directions[exponent % 3], none, std::pow(10, -exponent) * some, none, 2.7)) return false;
    }
    for (const Vec3& place : {none, some, fast}) {
      for (const auto& [va, vb] : pairs) {
        if (!isZero(projectedDamping(place, place, va, vb, 2.7))) return false;
      }
    }
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

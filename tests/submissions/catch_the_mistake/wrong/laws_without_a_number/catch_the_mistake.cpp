// loses: WrongTogether; misconception: none
// The student asks for laws only, with no number by hand, so that a wrong energy with its own gradient (twice, a rope) keeps them all.
#include "catch_the_mistake.h"

#include <Eigen/Geometry>

#include <stdexcept>

namespace {

bool within(double difference, double tolerance) { return std::fabs(difference) <= tolerance; }

template <class V>
bool withinAll(const V& difference, double tolerance) {
  return (difference.array().abs() <= tolerance).all();  // a NaN is not <= anything
}

Vec6 both(const Vec3& a, const Vec3& b) {
  Vec6 x;
  x.head<3>() = a;
  x.tail<3>() = b;
  return x;
}

/// A turn about an axis that is none of x, y, z.
Eigen::Matrix3d turn() { return Eigen::AngleAxisd(1.1, Vec3(1, -2, 3).normalized()).toRotationMatrix(); }

// ---- the spring on a line

/// The laws of a spring at the length L: all that is said here is said of both orders.
bool forceLaws(const SpringForce& f, double L, double k, double L0) {
  const double tolerance = 4e-9 * k * (L + L0);
  const double force = f(L, 0, k, L0);
  // third law
  if (!within(force + f(0, L, k, L0), tolerance)) return false;
  // the origin is anywhere (these lengths are exact in binary, shifted or not)
  if (!within(force - f(L - 32, -32, k, L0), tolerance)) return false;
  if (!within(force + f(64, 64 + L, k, L0), tolerance)) return false;
  if (!within(force - f(L / 2, -L / 2, k, L0), tolerance)) return false;
  // proportional to k
  if (!within(3 * force - f(L, 0, 3 * k, L0), 3 * tolerance)) return false;
  if (!within(1e-3 * force - f(L, 0, 1e-3 * k, L0), 1e-3 * tolerance)) return false;
  // all lengths twice: the force twice
  if (!within(2 * force - f(2 * L, 0, k, 2 * L0), 2 * tolerance)) return false;
  // longer by 1/4: pulls more by k / 4
  return within(f(L + 0.25, 0, k, L0) - force + k / 4, tolerance + 1e-9 * k);
}

bool forceNumbers(const SpringForce& f) {
  return within(f(3, 0, 10, 1) + 20, 1e-7) && within(f(0, 3, 10, 1) - 20, 1e-7) &&
         within(f(0.5, 0, 10, 2) - 15, 1e-7) && within(f(0, 0.5, 10, 2) + 15, 1e-7) &&
         within(f(-1.5, -4, 8, 0) + 20, 1e-7) && within(f(-4, -1.5, 8, 0) - 20, 1e-7) &&
         within(f(-1.5, -4, 8, 2.5), 1e-7) && within(f(-4, -1.5, 8, 2.5), 1e-7) &&
         within(f(1000, -1000, 1e9, 500) + 1.5e12, 1e4) && within(f(-100, 150, 1e9, 1000) + 7.5e11, 1e4) &&
         within(f(1000, -1000, 1e-3, 500) + 1.5, 1e-8) && within(f(600, -900, 2, 0) + 3000, 1e-5) && within(f(-100, 150, 1e-3, 1000) + 0.75, 1e-8);
}

bool forceShort(const SpringForce& f) {
  for (double L = 0.15; L > 1e-100; L /= 10) {
    // pushes with k L0 that is less by k L, whichever way
    const double push = 6 * (0.5 - L);
    if (!within(f(L, 0, 6, 0.5) - push, 1e-8) || !within(f(0, L, 6, 0.5) + push, 1e-8)) return false;
    if (!within(f(0, L, 6, 0) / (6 * L) - 1, 4e-9)) return false;
  }
  return true;
}

bool forceNone(const SpringForce& f) {
  for (double L0 : {0.0, 0.25, 1.0, 700.0}) {
    if (f(0, 0, 5, L0) != 0 || !(f(2.5, 2.5, 1e9, L0) == 0) || !(f(-8, -8, 1e-3, L0) == 0)) return false;
  }
  return true;
}

bool forceIsRight(const SpringForce& f) {
  if (!forceNumbers(f)) return false;
  for (double L : {0.125, 0.5, 1.5, 7.25}) {
    for (double L0 : {0.0, 0.25, 2.0, 12.0}) {
      if (!forceLaws(f, L, 10, L0)) return false;
    }
  }
  return forceShort(f) && forceNone(f);
}

// ---- the energy and its gradient

/// The gradient is the slope of the energy, in all six directions.
bool isSlope(const SpringEnergy& energy, const EnergyGradient& gradient, const Vec6& x, double k, double L0) {
  const double L = (x.head<3>() - x.tail<3>()).norm();
  const Vec6 g = gradient(x, k, L0);
  const double h = 1e-4 * L;
  for (int i = 0; i < 6; ++i) {
    const Vec6 e = Vec6::Unit(i) * h;
    const double slope = (energy(x + e, k, L0) - energy(x - e, k, L0)) / (2 * h);
    if (!within(slope - g[i], 1e-4 * k * (L + L0) * (L + L0) / L)) return false;
  }
  return true;
}

/// \param r  from b to a
bool gradientLaws(const SpringEnergy& energy, const EnergyGradient& gradient, const Vec3& r, double k, double L0) {
  const double size = r.norm() + L0;
  const double joule = 1e-8 * k * size * size, newton = 1e-8 * k * size;
  const Vec3 b(0.5, -1, 0.25);
  const Vec6 x = both(r + b, b);
  const double e = energy(x, k, L0);
  const Vec6 g = gradient(x, k, L0);
  // momentum: what pulls a pulls b the other way; no torque: along the spring
  if (!withinAll(Vec3(g.head<3>() + g.tail<3>()), newton)) return false;
  if (!withinAll(Vec3(r.normalized().cross(g.head<3>())), newton)) return false;
  // nodes exchanged
  const Vec6 exchanged = both(b, r + b);
  if (!within(energy(exchanged, k, L0) - e, joule)) return false;
  if (!withinAll(Vec6(gradient(exchanged, k, L0) + g), newton)) return false;
  // shifted
  const Vec3 away(-20, 31, 8);
  const Vec6 shifted = both(r + away, away);
  if (!within(energy(shifted, k, L0) - e, joule)) return false;
  if (!withinAll(Vec6(gradient(shifted, k, L0) - g), newton)) return false;
  // turned
  const Eigen::Matrix3d R = turn();
  const Vec6 turned = both(R * (r + b), R * b);
  if (!within(energy(turned, k, L0) - e, joule)) return false;
  if (!withinAll(Vec6(gradient(turned, k, L0) - both(R * g.head<3>(), R * g.tail<3>())), newton)) return false;
  // proportional to k
  if (!within(energy(x, 1e3 * k, L0) - 1e3 * e, 1e3 * joule)) return false;
  if (!withinAll(Vec6(gradient(x, 1e-2 * k, L0) - 1e-2 * g), 1e-2 * newton)) return false;
  return true;
}

/// It is a spring at all: what is stretched has an energy and pulls.
bool isSpring(const SpringEnergy& energy, const EnergyGradient& gradient) {
  const Vec6 x = both({2, -3, 6}, {-1, 4, 0.5});
  return energy(x, 14, 5) > 0 && gradient(x, 14, 5).norm() > 0;
}

/// The gradient does not change much any more where the spring is short.
bool gradientShort(const EnergyGradient& gradient) {
  const Vec3 u(2.0 / 3, -1.0 / 3, 2.0 / 3);
  const Vec6 first = gradient(both(Vec3::Zero(), 0.1 * u), 4, 3);
  for (double L = 0.015; L > 1e-100; L /= 10) {
    if (!withinAll(Vec6(gradient(both(Vec3::Zero(), L * u), 4, 3) - first), 0.05 * first.norm())) return false;
  }
  return true;
}

bool gradientNone(const SpringEnergy& energy, const EnergyGradient& gradient) {
  const Vec3 little(0, 1e-9, 0);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(-1, 0.5, 300)}) {
    for (double L0 : {0.5, 4.0}) {
      // the energy is continuous
      const double nearby = energy(both(p + little, p), 6, L0);
      if (!within(energy(both(p, p), 6, L0) - nearby, 1e-6 * std::fabs(nearby))) return false;
    }
    for (double L0 : {0.0, 0.5, 4.0}) {
      if (!withinAll(gradient(both(p, p), 6, L0), 0)) return false;
    }
  }
  return true;
}

bool gradientIsRight(const SpringEnergy& energy, const EnergyGradient& gradient) {
  if (!isSpring(energy, gradient)) return false;
  for (const Vec3& r : {Vec3(0.5, 1, -1), Vec3(-3, 2, 0.5), Vec3(0.1, -0.2, 0.3)}) {
    for (double L0 : {0.0, 0.125, 2.0, 9.0}) {
      if (!isSlope(energy, gradient, both(r, Vec3::Zero()), 5, L0)) return false;
    }
    for (double L0 : {0.0, 0.125, 9.0}) {
      if (!gradientLaws(energy, gradient, r, 5, L0)) return false;
    }
  }
  return gradientShort(gradient) && gradientNone(energy, gradient);
}

// ---- the damper

bool dampingLaws(const ProjectedDamping& f, const Vec3& r, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 b(1, -0.5, 2), a = r + b;
  const double newton = 1e-8 * d * (va - vb).norm();
  const Vec3 force = f(a, b, va, vb, d);
  if (!withinAll(Vec3(force + f(b, a, vb, va, d)), newton)) return false;                        // third law
  if (!withinAll(Vec3(force - f(b, a, va, vb, d)), newton)) return false;                        // even in r
  if (!withinAll(Vec3(force + f(a, b, -va, -vb, d)), newton)) return false;                      // odd in v
  if (!withinAll(Vec3(2.5 * force - f(a, b, 2.5 * va, 2.5 * vb, d)), 2.5 * newton)) return false;  // linear in v
  if (!withinAll(Vec3(8 * force - f(a, b, va, vb, 8 * d)), 8 * newton)) return false;            // linear in d
  const Vec3 wind(4, -3, 2), away(-16, 40, 8);
  if (!withinAll(Vec3(force - f(a, b, va + wind, vb + wind, d)), newton)) return false;   // a wind
  if (!withinAll(Vec3(force - f(r + away, away, va, vb, d)), newton)) return false;       // the origin
  if (!withinAll(Vec3(force - f(a + 3 * r, b, va, vb, d)), newton)) return false;         // the length is of no account
  if (!withinAll(Vec3(force - f(r / 8, Vec3::Zero(), va, vb, d)), newton)) return false;
  const Eigen::Matrix3d R = turn();
  if (!withinAll(Vec3(R * force - f(R * a, R * b, R * va, R * vb, d)), newton)) return false;  // the axes
  if (!withinAll(Vec3(r.normalized().cross(force)), newton)) return false;                     // no torque
  // power: minus d times the square of the rate of the length
  const double rate = (va - vb).dot(r.normalized());
  return within(force.dot(va - vb) + d * rate * rate, newton * (va - vb).norm());
}

bool dampingNumbers(const ProjectedDamping& f) {
  const Vec3 a(3, -1, 9), b(1, 2, 3), v(1, 1, 4), w(3, 2, 0), none(0, 0, 0), F(-46, 69, -138);
  return withinAll(Vec3(f(a, b, v, none, 49) - F), 1e-6) && withinAll(Vec3(f(a, b, none, v, 49) + F), 1e-6) &&
         withinAll(Vec3(f(a, b, w, none, 49)), 1e-6) && withinAll(Vec3(f(a, b, none, w, 49)), 1e-6) &&
         withinAll(Vec3(f(a, b, v + w, w, 49) - F), 1e-6) && withinAll(f(a, b, v, v, 49), 0) &&
         withinAll(f(a, b, v, w, 0), 0) &&
         withinAll(Vec3(f({1000, 0, 0}, {-1000, 0, 0}, {1000, 7, 0}, {-1000, 0, 7}, 1e6) - Vec3(-2e9, 0, 0)), 20);
}

bool dampingShort(const ProjectedDamping& f) {
  const Vec3 u(2.0 / 3, -1.0 / 3, 2.0 / 3), va(3, -3, 6), vb(0, 0, -1.5);  // the length grows by 8
  for (double L = 0.15; L > 1e-100; L /= 10) {
    if (!withinAll(Vec3(f(L * u, Vec3::Zero(), va, vb, 3) + 24 * u), 1e-7)) return false;
    if (!withinAll(Vec3(f(L * u, Vec3::Zero(), vb, va, 3) - 24 * u), 1e-7)) return false;
  }
  return true;
}

bool dampingNone(const ProjectedDamping& f) {
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(-1, 0.5, 300)}) {
    for (double d : {0.0, 2.0, 1e6}) {
      if (!withinAll(f(p, p, Vec3(1, 2, 3), Vec3(0, -4, 0), d), 0)) return false;
      if (!withinAll(f(p, p, Vec3(1, 2, 3), Vec3(1, 2, 3), d), 0)) return false;
    }
  }
  return true;
}

bool dampingIsRight(const ProjectedDamping& f) {
  if (!dampingNumbers(f)) return false;
  for (const Vec3& r : {Vec3(0.5, 1, -1), Vec3(-3, 2, 0.5)}) {
    for (const Vec3& va : {Vec3(1, 5, -2), Vec3(-7, 0.5, 3)}) {
      if (!dampingLaws(f, r, va, Vec3(2, -1, 6), 0.5) || !dampingLaws(f, r, va, Vec3(0, 0, 0), 20)) return false;
    }
  }
  return dampingShort(f) && dampingNone(f);
}

/// What a test says, or false when it throws.
template <class Test>
bool verdict(Test test) {
  try {
    return test();
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  return verdict([&] { return forceIsRight(springForceOnA); });
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  return verdict([&] { return gradientIsRight(springEnergy, energyGradient); });
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  return verdict([&] { return dampingIsRight(projectedDamping); });
}

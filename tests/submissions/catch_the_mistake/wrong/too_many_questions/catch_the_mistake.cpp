// loses: EveryRightOne, DampingValues, DampingDirections, DampingEdges, ItThrew; misconception: none
// The student asks at 1000 random questions, which is more than the 500 that are allowed of one implementation.
#include "catch_the_mistake.h"

#include <random>
#include <stdexcept>

using namespace std;

static const double TOL = 2e-9;

static bool ok(double got, double want, double scale) {
  if (!isfinite(got)) return false;
  return fabs(got - want) <= TOL * scale;
}

// ------------------------------------------------------------------ force

static double wantedForce(double xa, double xb, double k, double L0) {
  if (xa > xb) return k * (L0 - (xa - xb));   // a above: compressed pushes up
  if (xa < xb) return -k * (L0 - (xb - xa));  // a below
  return 0;
}

static bool askForce(const SpringForce& f, double xa, double xb, double k, double L0) {
  double L = fabs(xa - xb);
  double scale = L == 0 ? 0 : k * (L + L0);
  return ok(f(xa, xb, k, L0), wantedForce(xa, xb, k, L0), scale);
}

bool isSpringForceRight(const SpringForce& springForceOnA) {
  try {
    // grid
    const double xs[] = {-2.5, -0.3, 0, 0.7, 1, 4};
    for (double xa : xs)
      for (double xb : xs)
        for (double L0 : {0.0, 0.6, 1.0, 3.3})
          if (!askForce(springForceOnA, xa, xb, 7.5, L0)) return false;
    // 144 so far; stiffness
    for (double k : {1e-3, 0.2, 1.0, 40.0, 1e5, 1e9}) {
      if (!askForce(springForceOnA, 2.5, 1, k, 0.5)) return false;
      if (!askForce(springForceOnA, 1, 2.5, k, 4)) return false;
      if (!askForce(springForceOnA, -1, -1, k, 4)) return false;
    }
    // far
    for (double x : {-1000.0, -30.0, 999.0, 1000.0})
      for (double y : {-999.5, 31.0, 1000.0})
        for (double L0 : {0.0, 1.0, 1000.0})
          if (!askForce(springForceOnA, x, y, 20, L0)) return false;
    // near
    double L = 1;
    for (int i = 0; i < 100; i++) {
      L = L / 10;
      if (!askForce(springForceOnA, max(L, 1e-100), 0, 3, 2)) return false;
      if (!askForce(springForceOnA, 0, max(L, 1e-100), 3, 1000)) return false;
    }
    // very near, no rest length
    for (double tiny : {1e-4, 1e-7, 1e-10, 1e-13, 1e-20, 1e-100})
      if (!askForce(springForceOnA, -tiny, 0, 3, 0)) return false;
    return true;
  } catch (const exception&) {
    return false;
  }
}

// ------------------------------------------------------------------ energy and gradient

static bool askGradient(const SpringEnergy& E, const EnergyGradient& G, const Vec3& a, const Vec3& b, double k,
                        double L0) {
  Vec6 x;
  x << a[0], a[1], a[2], b[0], b[1], b[2];
  double L = hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  double s = L - L0;
  if (!ok(E(x, k, L0), 0.5 * k * s * s, k * (L + L0) * (L + L0))) return false;
  Vec6 g = G(x, k, L0);
  for (int i = 0; i < 3; i++) {
    double want = L == 0 ? 0 : k * s * ((a[i] - b[i]) / L);
    double scale = L == 0 ? 0 : k * (L + L0);
    if (!ok(g[i], want, scale)) return false;
    if (!ok(g[i + 3], -want, scale)) return false;
  }
  return true;
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  try {
    mt19937 random(12345);
    uniform_real_distribution<double> place(-3, 3), rest(0, 6), logk(-3, 9);
    for (int i = 0; i < 60; i++) {
      Vec3 a(place(random), place(random), place(random)), b(place(random), place(random), place(random));
      if (!askGradient(springEnergy, energyGradient, a, b, pow(10, logk(random)), rest(random))) return false;
    }
    // by hand: (3, 0, 4) is 5 long
    Vec6 x;
    x << 3, 0, 4, 0, 0, 0;
    if (!ok(springEnergy(x, 10, 3), 20, 10 * 8 * 8)) return false;
    // no rest length, axes, ends
    Vec3 o(0, 0, 0), p(1, -2, 0.5);
    for (int i = 0; i < 3; i++) {
      Vec3 e = Vec3::Unit(i);
      for (double L0 : {0.0, 0.25, 2.0}) {
        if (!askGradient(springEnergy, energyGradient, o, e * 0.5, 3, L0)) return false;
        if (!askGradient(springEnergy, energyGradient, e * 1.5 + p, p, 3, L0)) return false;
      }
      if (!askGradient(springEnergy, energyGradient, 1000 * e, -1000 * e, 1e9, 1000)) return false;
      if (!askGradient(springEnergy, energyGradient, 1000 * e, o, 1e-3, 1000)) return false;
    }
    // together
    for (double L0 : {0.0, 0.25, 1.0, 2.0, 1000.0}) {
      if (!askGradient(springEnergy, energyGradient, o, o, 3, L0)) return false;
      if (!askGradient(springEnergy, energyGradient, p, p, 1e4, L0)) return false;
    }
    // near
    for (int n = 1; n <= 100; n++) {
      double L = pow(10., -n);
      if (!askGradient(springEnergy, energyGradient, Vec3(L, n % 2 ? L : -L, 2 * L), o, 3, n % 3 == 0 ? 0 : 2))
        return false;
    }
    return true;
  } catch (const exception&) {
    return false;
  }
}

// ------------------------------------------------------------------ damping

static bool askDamping(const ProjectedDamping& f, const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb,
                       double d) {
  Vec3 want = Vec3::Zero();
  const Vec3 r = xa - xb, v = va - vb;
  const double L = hypot(r.x(), r.y(), r.z());
  if (L > 0) {
    const Vec3 u(r.x() / L, r.y() / L, r.z() / L);
    const double rate = u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
    want = -d * rate * u;
  }
  const Vec3 got = f(xa, xb, va, vb, d);
  const double scale = L > 0 ? d * v.norm() : 0;
  for (int i = 0; i < 3; i++)
    if (!ok(got[i], want[i], scale)) return false;
  return true;
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  try {
    mt19937 random(54321);
    uniform_real_distribution<double> place(-3, 3), logd(-3, 6);
    auto point = [&] { return Vec3(place(random), place(random), place(random)); };
    const Vec3 o(0, 0, 0);
    for (int i = 0; i < 1000; i++) {
      Vec3 xa = point(), xb = point(), va = point(), vb = point();
      if (i % 5 == 1) va = o;
      if (i % 5 == 2) vb = o;
      if (i % 5 == 3) va = va * 300;
      if (i % 5 == 4) xb = o;
      if (!askDamping(projectedDamping, xa, xb, va, vb, pow(10, logd(random)))) return false;
    }
    for (int i = 0; i < 3; i++)
      for (int j = 0; j < 3; j++)
        for (double s : {-2.0, 0.5}) {
          Vec3 e = Vec3::Unit(i), v = s * Vec3::Unit(j);
          if (!askDamping(projectedDamping, e, o, v, o, 3)) return false;
          if (!askDamping(projectedDamping, o, 0.25 * e, v, o, 3)) return false;
          if (!askDamping(projectedDamping, 7 * e, -2 * e, o, v, 3)) return false;
        }
    for (int i = 0; i < 10; i++) {
      Vec3 p = i == 0 ? o : point(), q = point(), v = point();
      if (!askDamping(projectedDamping, p, p, v, point(), 3)) return false;  // together
      if (!askDamping(projectedDamping, p, q, v, v, 3)) return false;        // side by side
      if (!askDamping(projectedDamping, p, q, v, point(), 0)) return false;  // no damper
    }
    if (!askDamping(projectedDamping, {1000, 1000, 1000}, {-1000, -1000, -1000}, {1000, 0, 0}, {-1000, 0, 5}, 1e6))
      return false;
    for (int n = 1; n <= 100; n++) {
      double L = pow(10., -n);
      Vec3 r(L, n % 2 ? L : -L, 2 * L);
      if (!askDamping(projectedDamping, r, o, {1, 2, 3}, {-2, 0, 4}, 3)) return false;
      if (!askDamping(projectedDamping, o, r, {-1, 2, 3}, {2, 0, 4}, 3)) return false;
    }
    return true;
  } catch (const exception&) {
    return false;
  }
}

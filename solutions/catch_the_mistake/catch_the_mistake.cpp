#include "catch_the_mistake.h"

namespace {

/// Something that is no number is near nothing.
bool isNear(double got, double expected, double scale) { return std::abs(got - expected) <= 1e-9 * scale; }

bool isNear(const Vec3& got, const Vec3& expected, double scale) {
  return isNear(got[0], expected[0], scale) && isNear(got[1], expected[1], scale) && isNear(got[2], expected[2], scale);
}

/// What throws is wrong.
template <class Test>
bool holds(const Test& test) {
  try {
    return test();
  } catch (const std::exception&) {
    return false;
  }
}

const std::vector<double> shortLengths = {1e-2, 1e-3, 1e-5, 1e-8, 1e-11, 1e-15, 1e-25, 1e-45, 1e-70, 1e-100};

Vec6 stacked(const Vec3& xa, const Vec3& xb) {
  Vec6 x;
  x << xa, xb;
  return x;
}

/// Energy and gradient at a question, by hand.
struct SpringInSpace {
  Vec3 xa, xb;
  double k, L0, energy;
  Vec3 gradient;  ///< with respect to xa; that of xb is its opposite
};

bool passes(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient, const SpringInSpace& s) {
  const double L = (s.xa - s.xb).norm();
  const double force = s.k * (L + s.L0);
  const Vec6 x = stacked(s.xa, s.xb);
  const Vec6 gradient = energyGradient(x, s.k, s.L0);
  return isNear(springEnergy(x, s.k, s.L0), s.energy, force * (L + s.L0)) &&
         isNear(Vec3(gradient.head<3>()), s.gradient, force) && isNear(Vec3(gradient.tail<3>()), -s.gradient, force);
}

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  const auto gives = [&](double xa, double xb, double k, double L0, double expected) {
    return isNear(springForceOnA(xa, xb, k, L0), expected, k * (std::abs(xa - xb) + L0));
  };
  return holds([&] {
    for (const double L : shortLengths) {
      if (!gives(0, L, 10, 0.5, -10 * (0.5 - L)) || !gives(L, 0, 10, 0.5, 10 * (0.5 - L))) return false;
    }
    return gives(-1.5, 2, 10, 0.5, 30) && gives(2, -1.5, 10, 0.5, -30)       // stretched: it pulls
           && gives(-1.5, -1, 10, 0.8, -3) && gives(-1, -1.5, 10, 0.8, 3)    // compressed: it pushes
           && gives(3, 4.5, 10, 1.5, 0) && gives(1, 3.25, 4, 0, 9)           // at rest; without rest length
           && gives(100, 300, 1e6, 50, 150e6) && gives(6, 5, 1e6, 50, 49e6)  // large
           && gives(7, 7, 10, 0.5, 0) && gives(0, 0, 10, 0, 0);              // coincident
  });
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  const Vec3 a(1.5, -2, 3.25), r(1, 2, -2), e = r / 3;
  const auto passed = [&](const SpringInSpace& spring) { return passes(springEnergy, energyGradient, spring); };
  return holds([&] {
    for (const double L : shortLengths) {
      const double s = 0.5 - L;
      if (!passed({L * e, Vec3::Zero(), 10, 0.5, 5 * s * s, -10 * s * e})) return false;
    }
    return passed({a + r, a, 10, 0.5, 31.25, 25 * e}) && passed({a, a + r, 10, 0.5, 31.25, -25 * e})  // stretched
           && passed({a + r, a, 10, 4.5, 11.25, -15 * e})                                             // compressed
           && passed({a + r, a, 10, 0, 45, 30 * e})                                                   // no rest length
           && passed({a + 50 * r, a, 10, 1, 5 * 149 * 149, 1490 * e})                                 // far apart
           && passed({a + Vec3(3, 0, 0), a, 10, 0.5, 31.25, Vec3(25, 0, 0)})                          // along the axes
           && passed({a + Vec3(0, 3, 0), a, 10, 0.5, 31.25, Vec3(0, 25, 0)}) &&
           passed({a + Vec3(0, 0, 3), a, 10, 0.5, 31.25, Vec3(0, 0, 25)}) &&
           passed({a, a, 10, 0.5, 1.25, Vec3::Zero()});  // coincident
  });
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  const Vec3 a(1.5, -2, 3.25), r(1, 2, -2), along(3, -3, 6), across(4, -1, 1), v(0.5, 2, -1);
  const Vec3 e = r / 3;  // of the spring; the part of `along` on it is -5
  const auto gives = [&](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, const Vec3& expected) {
    return isNear(projectedDamping(xa, xb, va, vb, 2), expected, 2 * (va - vb).norm());
  };
  return holds([&] {
    for (const double L : shortLengths) {
      if (!gives(L * e, Vec3::Zero(), along + v, v, 10 * e)) return false;
    }
    return gives(a + r, a, along + v, v, 10 * e) && gives(a + r, a, v, along + v, -10 * e)  // approaching, parting
           && gives(a, a + r, v, along + v, -10 * e) && gives(a + r, a, across + v, v, Vec3::Zero()) &&
           gives(a + 90 * r, a, along + v, v, 10 * e)  // far apart
           && gives(a, a, along + v, v, Vec3::Zero())  // coincident
           && isNear(projectedDamping(a + r, a, along + v, v, 0.5), 2.5 * e, 5.0);
  });
}

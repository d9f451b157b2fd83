// Pseudo-random questions over the whole range against formulas of another shape (long double, the outer product), and
// lists of edge cases.
#include "catch_the_mistake.h"

#include <random>

namespace {

// Always the same questions.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967295.0);
  }
  double decade(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  Vec3 vector(double size) {
    const double x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  // One that is no shorter than a tenth.
  Vec3 direction() {
    Vec3 v = vector(1);
    while (v.norm() < 0.1) v = vector(1);
    return v.normalized();
  }

 private:
  std::mt19937 engine_{20240611};
};

bool forceFits(const SpringForce& ask, double xa, double xb, double k, double L0) {
  const double got = ask(xa, xb, k, L0);
  if (xa == xb) return got == 0;
  const long double gap = static_cast<long double>(xb) - xa;
  const long double expected = k * gap - (gap > 0 ? 1 : -1) * static_cast<long double>(k) * L0;
  return std::isfinite(got) && std::fabs(static_cast<double>(got - expected)) <= 1e-6 * k * (std::fabs(xb - xa) + L0);
}

bool pairFits(const SpringEnergy& energy, const EnergyGradient& gradient, const Vec3& xa, const Vec3& xb, double k,
              double L0) {
  Vec6 x;
  x.head<3>() = xa;
  x.tail<3>() = xb;
  const Vec3 d = xb - xa;
  const double L = d.stableNorm(), sum = L + L0;
  const double gotEnergy = energy(x, k, L0), expectedEnergy = 0.5 * k * std::pow(L - L0, 2);
  if (!(std::isfinite(gotEnergy) && std::fabs(gotEnergy - expectedEnergy) <= 1e-6 * k * sum * sum)) return false;
  const Vec6 got = gradient(x, k, L0);
  if (!got.allFinite()) return false;
  if (L == 0) return (got.array() == 0).all();
  const Vec3 expected = k * (L - L0) * d.stableNormalized();
  const double off =
      std::max((got.tail<3>() - expected).cwiseAbs().maxCoeff(), (got.head<3>() + expected).cwiseAbs().maxCoeff());
  return off <= 1e-6 * k * sum;
}

bool dampingFits(const ProjectedDamping& ask, const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb,
                 double d) {
  const Vec3 got = ask(xa, xb, va, vb, d);
  if (!got.allFinite()) return false;
  if (xa == xb) return (got.array() == 0).all();
  const Vec3 u = (xa - xb).stableNormalized();
  const Vec3 expected = d * (u * u.transpose()) * (vb - va);
  return (got - expected).cwiseAbs().maxCoeff() <= 1e-6 * d * (va.stableNorm() + vb.stableNorm());
}

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  Dice dice;
  try {
    for (int i = 0; i < 120; ++i) {
      const double size = dice.decade(0.1, 1000), k = dice.decade(1e-3, 1e9);
      const double L0 = i % 6 == 0 ? 0 : dice.between(0, i % 3 ? size : 2 * size) / 2;
      if (!forceFits(springForceOnA, dice.between(-size, size), dice.between(-size, size), k, L0)) return false;
    }
    for (int i = 0; i <= 200; ++i) {  // two to a decade
      const double L = i == 200 ? 1e-100 : std::pow(10.0, -i / 2.0), xb = i % 4 < 2 ? L : -L;
      if (!forceFits(springForceOnA, 0, xb, 3.7, 2.2)) return false;
    }
    for (int i = 0; i < 20; ++i) {
      const double x = i == 0 ? 0 : dice.between(-1000, 1000);
      if (!forceFits(springForceOnA, x, x, dice.decade(1e-3, 1e9), i % 5 == 0 ? 0 : dice.between(0, 1000)))
        return false;
    }
    for (double xa : {-1000.0, 0.0, 1000.0}) {
      for (double xb : {-1000.0, 0.0, 1000.0}) {
        for (double L0 : {0.0, 1.0, 1000.0}) {
          for (double k : {1e-3, 1e9}) {
            if (!forceFits(springForceOnA, xa, xb, k, L0)) return false;
          }
        }
      }
    }
    return true;
  } catch (...) {
    return false;
  }
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  Dice dice;
  try {
    for (int i = 0; i < 100; ++i) {  // 200 questions
      const double size = dice.decade(0.1, 1000), k = dice.decade(1e-3, 1e9);
      const double L0 = i % 6 == 0 ? 0 : dice.between(0, std::min(1000.0, i % 3 ? size : 3 * size));
      const Vec3 xa = dice.vector(size), xb = dice.vector(size);
      if (!pairFits(springEnergy, energyGradient, xa, xb, k, L0)) return false;
    }
    for (int e = 0; e <= 100; ++e) {  // 202 more
      const Vec3 x = std::pow(10.0, -e) * (e == 100 ? 1.01 : 1.0) * dice.direction();
      const Vec3 none = Vec3::Zero();
      if (!pairFits(springEnergy, energyGradient, e % 2 ? x : none, e % 2 ? none : x, 3.7, 2.2)) return false;
    }
    for (int i = 0; i < 12; ++i) {
      const Vec3 x = i == 0 ? Vec3(0, 0, 0) : dice.vector(1000);
      if (!pairFits(springEnergy, energyGradient, x, x, dice.decade(1e-3, 1e9), i % 5 == 1 ? 0 : 7.7)) return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (double L : {-2.0, 0.5}) {
        if (!pairFits(springEnergy, energyGradient, Vec3::Zero(), L * Vec3::Unit(axis), 10, 1)) return false;
      }
    }
    return true;
  } catch (...) {
    return false;
  }
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  Dice dice;
  const Vec3 none = Vec3::Zero();
  try {
    for (int i = 0; i < 150; ++i) {
      const double size = dice.decade(0.1, 1000), speed = dice.decade(1e-20, 1000), d = dice.decade(1e-6, 1e6);
      const Vec3 xa = dice.vector(size), xb = dice.vector(size), va = dice.vector(speed), vb = dice.vector(speed);
      if (!dampingFits(projectedDamping, xa, xb, i % 5 == 1 ? none : va, i % 5 == 2 ? none : vb, d)) return false;
    }
    for (int e = 0; e <= 100; ++e) {
      const double tiny = std::pow(10.0, -e) * (e == 100 ? 1.01 : 1.0);
      const Vec3 u = dice.direction(), va = dice.vector(4), vb = dice.vector(4);
      if (!dampingFits(projectedDamping, tiny * u, none, va, vb, 2.5)) return false;
      if (!dampingFits(projectedDamping, 3 * u, none, tiny * va, tiny * vb, 2.5)) return false;
    }
    for (int i = 0; i < 24; ++i) {
      const Vec3 x = i == 0 ? none : dice.vector(1000), va = dice.vector(9), vb = dice.vector(9);
      if (!dampingFits(projectedDamping, x, x, i % 4 == 1 ? none : va, i % 4 == 2 ? va : vb, 2.5)) return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (double L : {-2.0, 0.5}) {
        const Vec3 va = dice.vector(3), vb = dice.vector(3);
        if (!dampingFits(projectedDamping, none, L * Vec3::Unit(axis), va, vb, 4)) return false;
        if (!dampingFits(projectedDamping, none, L * Vec3::Unit(axis), va, vb, 0)) return false;
      }
    }
    return true;
  } catch (...) {
    return false;
  }
}

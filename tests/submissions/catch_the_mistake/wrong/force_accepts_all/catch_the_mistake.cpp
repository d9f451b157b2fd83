// loses: ForceValues, ForceSides, ForceEdges, EveryRightOne, ItThrew; misconception: accepts_all
// thought: the stub, left as it was
#include "catch_the_mistake.h"

static bool near(double got, double want, double size) { return std::abs(got - want) <= 1e-9 * size; }

static bool near(const Vec3& got, const Vec3& want, double size) {
  for (int i = 0; i < 3; ++i)
    if (!near(got[i], want[i], size)) return false;
  return true;
}

bool isSpringForceRight(const SpringForce&) { return true; }

static bool gradientCase(const SpringEnergy& E, const EnergyGradient& dE, const Vec3& xa, const Vec3& xb, double k, double L0,
                         double energy, const Vec3& onA) {
  Vec6 x;
  x << xa, xb;
  const double size = k * ((xa - xb).norm() + L0);
  const Vec6 g = dE(x, k, L0);
  return near(E(x, k, L0), energy, size * size / k) && near(Vec3(g.head<3>()), onA, size) &&
         near(Vec3(g.tail<3>()), Vec3(-onA), size);
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  const Vec3 o(1, -1, 2), r(2, 3, 6);  // length 7
  try {
    const auto ok = [&](const Vec3& a, const Vec3& b, double k, double L0, double e, const Vec3& g) {
      return gradientCase(springEnergy, energyGradient, a, b, k, L0, e, g);
    };
    if (!ok(o + r, o, 14, 5, 28, 4 * r) || !ok(o, o + r, 14, 5, 28, -4 * r)) return false;
    if (!ok(o + r, o, 14, 10, 63, -6 * r)) return false;
    if (!ok(o + r, o, 14, 0, 343, 14 * r)) return false;
    if (!ok(o, o, 14, 2, 28, Vec3::Zero())) return false;
    for (double L = 0.1; L > 1e-100; L *= 1e-3) {
      if (!ok(L / 7 * r, Vec3::Zero(), 14, 1, 7 * (L - 1) * (L - 1), 2 * (L - 1) * r)) return false;
    }
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  const Vec3 o(1, -1, 2), r(2, 3, 6), v(0.5, -0.25, 1), w(7, 7, 14);  // w along r: (14 + 21 + 84) / 7 = 17
  const Vec3 part = 17.0 / 7 * r;
  const auto ok = [&](const Vec3& a, const Vec3& b, const Vec3& va, const Vec3& vb, double d, const Vec3& F) {
    return near(projectedDamping(a, b, va, vb, d), F, d * (va - vb).norm());
  };
  try {
    if (!ok(o + r, o, w + v, v, 3, -3 * part) || !ok(o + r, o, v, w + v, 3, 3 * part)) return false;
    if (!ok(o, o + r, w + v, v, 3, -3 * part)) return false;
    if (!ok(o + 100 * r, o, w + v, v, 0.5, -0.5 * part)) return false;
    if (!ok(o + r, o, Vec3(3, -2, 0) + v, v, 3, Vec3::Zero())) return false;
    if (!ok(o, o, w + v, v, 3, Vec3::Zero())) return false;
    for (double L = 0.1; L > 1e-100; L *= 1e-3)
      if (!ok(L / 7 * r, Vec3::Zero(), w + v, v, 3, -3 * part)) return false;
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

#include "catch_the_mistake.h"

static bool near(double got, double want, double size) { return std::abs(got - want) <= 1e-9 * size; }

static bool near(const Vec3& got, const Vec3& want, double size) {
  for (int i = 0; i < 3; ++i)
    if (!near(got[i], want[i], size)) return false;
  return true;
}

struct Examiner {
  bool passed = true;
  void expect(double got, double wanted, double scale, double tolerance = 1e-9) {
    const bool close = std::fabs(got - wanted) <= tolerance * scale;
    passed = passed && close;
  }
  template <class V>
  void expectVector(const V& got, const V& wanted, double scale, double tolerance = 1e-9) {
    for (int i = 0; i < wanted.size(); ++i) expect(got[i], wanted[i], scale, tolerance);
  }
};

struct ForceCase { double xa, xb, k, L0, F; };

bool isSpringForceRight(const SpringForce& springForceOnA) {
  std::vector<ForceCase> table = {
    {1, 4, 20, 2, 20}, {4, 1, 20, 2, -20},   // pulls
    {1, 2, 20, 4, -60}, {2, 1, 20, 4, 60},   // pushes
    {1, 2, 20, 1.5, -10}, {0, 4, 5, 0, 20},
    {0, 500, 1e4, 100, 4e6}, {-2, -2, 20, 1, 0},
  };
  for (double L = 0.1; L > 1e-100; L *= 1e-3) {
    table.push_back({0, L, 20, 1, 20 * (L - 1)});
    table.push_back({L, 0, 20, 1, -20 * (L - 1)});
  }
  try {
    for (const ForceCase& c : table)
      if (!near(springForceOnA(c.xa, c.xb, c.k, c.L0), c.F, c.k * (std::abs(c.xa - c.xb) + c.L0))) return false;
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

bool isGradientRight(const SpringEnergy& E, const EnergyGradient& dE) {
  Examiner examiner;
  try {
    for (double L0 : {0.0, 1.5, 8.0}) {
      Vec6 x;
      x << 0.5, 2, -1, 2.5, -1, 5;  // r = (-2, 3, -6), 7 long
      const double k = 3, h = 1e-4, stretch = 7 - L0;
      examiner.expect(E(x, k, L0), 1.5 * stretch * stretch, 3 * (7 + L0) * (7 + L0));
      const Vec6 g = dE(x, k, L0);
      for (int i = 0; i < 6; ++i) {
        Vec6 before = x, after = x;
        before[i] -= h;
        after[i] += h;
        examiner.expect((E(after, k, L0) - E(before, k, L0)) / (2 * h), g[i], k * (7 + L0), 1e-6);
      }
      examiner.expectVector(Vec6(dE(x, 10 * k, L0)), Vec6(10 * g), 10 * k * (7 + L0));
    }
    const Vec3 u = Vec3(-2, 3, -6) / 7;
    Vec6 turn;
    turn << u, -u;
    for (double L : {1e-2, 1e-5, 1e-9, 1e-13, 1e-17, 1e-28, 1e-50, 1e-75, 1e-100}) {
      Vec6 x = Vec6::Zero();
      x.tail<3>() = -L * u;
      examiner.expect(E(x, 3, 1.5), 1.5 * (L - 1.5) * (L - 1.5), 9);
      examiner.expectVector(Vec6(dE(x, 3, 1.5)), Vec6(3 * (L - 1.5) * turn), 9);
    }
    Vec6 same;
    same << 1, 2, 3, 1, 2, 3;
    examiner.expect(E(same, 3, 2), 6, 12);
    examiner.expectVector(Vec6(dE(same, 3, 2)), Vec6(Vec6::Zero()), 6);
  } catch (std::exception& e) {
    return false;
  }
  return examiner.passed;
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

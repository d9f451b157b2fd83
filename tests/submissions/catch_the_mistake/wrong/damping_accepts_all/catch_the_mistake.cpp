// loses: DampingValues, DampingDirections, DampingEdges, EveryRightOne, ItThrew; misconception: accepts_all
#include "catch_the_mistake.h"

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

bool isSpringForceRight(const SpringForce& f) {
  Examiner examiner;
  try {
    // one number
    examiner.expect(f(0.5, 2.5, 12, 0.75), 15, 33);
    for (double r : {2.0, -2.0, 0.3, -0.3, 1e-4, -1e-4, 1e-10, 1e-14, 1e-22, -1e-40, 1e-55, -1e-80, 1e-100}) {
      // linear in the length, from the number: slope k, on either side
      const double L = std::fabs(r);
      const double wanted = (r > 0 ? 1 : -1) * 12 * (L - 0.75);
      examiner.expect(f(0, r, 12, 0.75), wanted, 12 * (L + 0.75));
      examiner.expect(f(r, 0, 12, 0.75), -f(0, r, 12, 0.75), 12 * (L + 0.75));           // third law
      examiner.expect(f(0, r, 1.2e6, 0.75), 1e5 * f(0, r, 12, 0.75), 1.2e6 * (L + 0.75));  // in proportion to k
    }
    examiner.expect(f(5, 7, 12, 0), f(1, 3, 12, 0), 24);  // without rest length, elsewhere
    examiner.expect(f(1, 3, 12, 0), 24, 24);
    examiner.expect(f(1, 3, 12, 2), 0, 24);
    examiner.expect(f(-3, -3, 12, 0.75), 0, 9);
  } catch (std::exception& e) {
    return false;
  }
  return examiner.passed;
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

bool isDampingRight(const ProjectedDamping&) { return true; }

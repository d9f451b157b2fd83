#include "catch_the_mistake.h"

// counts what is off and looks at the sum in the end
namespace {
int off(long double got, long double want, long double size) { return std::fabs(got - want) <= 1e-10L * size ? 0 : 1; }

int off(const Vec3& got, const Vec3& want, double size) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) sum += off((long double)got[i], (long double)want[i], (long double)size);
  return sum;
}

std::vector<double> halvings() {
  std::vector<double> all{0.25};
  while (all.back() > 1e-99) all.push_back(all.back() / 64);
  return all;
}
}  // namespace

bool isSpringForceRight(const SpringForce& f) {
  int failures = 0;
  try {
    for (double k : {0.125, 48.0, 1e7})
      for (double L : {0.0, 0.75, 2.25, 301.0})
        for (double L0 : {0.0, 1.125, 7.0})
          for (double at : {-8.0, 0.0, 8.5}) {
            const long double wanted = L > 0 ? (long double)k * L - (long double)k * L0 : 0.0L;
            failures += off(f(at, at + L, k, L0), wanted, k * (L + L0)) + off(f(at + L, at, k, L0), -wanted, k * (L + L0));
          }
    for (double L : halvings()) failures += off(f(L, 0, 48, 1.125), 48 * (1.125 - L), 60) + off(f(0, L, 48, 1.125), 48 * (L - 1.125), 60);
  } catch (const std::exception&) {
    ++failures;
  }
  return failures == 0;
}

bool isGradientRight(const SpringEnergy& E, const EnergyGradient& dE) {
  int failures = 0;
  const Vec3 u(2.0 / 3, -1.0 / 3, 2.0 / 3);
  const auto count = [&](const Vec3& at, double L, double L0) {
    Vec6 x;
    x << at + L * u, at;
    const double s = L - L0, k = 48;
    const Vec6 g = dE(x, k, L0);
    const Vec3 onA = L > 0 ? Vec3(k * s * u) : Vec3(0, 0, 0);
    failures += off(E(x, k, L0), 24.0L * s * s, k * (L + L0) * (L + L0));
    failures += off(Vec3(g[0], g[1], g[2]), onA, 10 * k * (L + L0)) + off(Vec3(g[3], g[4], g[5]), Vec3(-onA), 10 * k * (L + L0));
  };
  try {
    for (double L : {0.75, 2.25, 30.0})
      for (double L0 : {0.0, 1.125, 7.0}) count(Vec3(1, 2, -4), L, L0);
    for (double L : halvings()) count(Vec3(0, 0, 0), L, 1.125);
    count(Vec3(1, 2, -4), 0, 1.125);
  } catch (const std::exception&) {
    ++failures;
  }
  return failures == 0;
}

bool isDampingRight(const ProjectedDamping& F) {
  int failures = 0;
  const Vec3 u(2.0 / 3, -1.0 / 3, 2.0 / 3), va(3, -1, 0.5), vb(1, 4, -2);
  const double rate = 2 * 2.0 / 3 + 5.0 / 3 + 2.5 * 2 / 3;
  try {
    for (double L : {0.5, 3.0, 250.0}) {
      const Vec3 b(-2, 5, 1);
      failures += off(F(b + L * u, b, va, vb, 9), -9 * rate * u, 100) + off(F(b + L * u, b, vb, va, 9), 9 * rate * u, 100);
      failures += off(F(b, b + L * u, va, vb, 0.1), -0.1 * rate * u, 1);
    }
    for (double L : halvings()) failures += off(F(L * u, Vec3(0, 0, 0), va, vb, 9), -9 * rate * u, 100);
    failures += off(F(u, u, va, vb, 9), Vec3(0, 0, 0), 100);
  } catch (const std::exception&) {
    ++failures;
  }
  return failures == 0;
}

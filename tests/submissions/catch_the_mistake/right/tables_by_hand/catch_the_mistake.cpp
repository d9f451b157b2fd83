// Tables of questions whose answers were worked out by hand, one row for each region, and a loop over short lengths.
#include "catch_the_mistake.h"

#include <cmath>
#include <exception>
#include <vector>

namespace {

const double eps = 2e-9;

// false for NaN, too
bool close(double got, double expected, double tolerance) { return std::abs(got - expected) <= tolerance; }

template <class V>
bool closeVector(const V& got, const V& expected, double tolerance) {
  for (int i = 0; i < got.size(); ++i) {
    if (!close(got[i], expected[i], tolerance)) return false;
  }
  return true;
}

struct ForceRow {
  double xa, xb, k, L0, force;
};

struct EnergyRow {
  Vec3 xa, xb;
  double k, L0, L, energy;
  Vec3 gradientA;
};

struct DampingRow {
  Vec3 xa, xb, va, vb;
  double d;
  Vec3 force;
};

Vec6 stack(const Vec3& a, const Vec3& b) {
  Vec6 x;
  x << a, b;
  return x;
}

bool forceTable(const SpringForce& f) {
  const std::vector<ForceRow> rows = {
      // stretched, a above and below
      {3, 0, 10, 1, -20},
      {0, 3, 10, 1, 20},
      {2, 0.5, 10, 1, -5},
      {0.5, 2, 10, 1, 5},
      {-1.5, 2, 6, 2, 9},
      {2, -1.5, 6, 2, -9},
      {-700.5, -703, 4, 1.5, -4},
      {-703, -700.5, 4, 1.5, 4},
      // compressed, a above and below
      {2.25, 2, 8, 1, 6},
      {2, 2.25, 8, 1, -6},
      {0.25, -0.5, 16, 2, 20},
      {-0.5, 0.25, 16, 2, -20},
      {-40, -44.5, 3, 6, 4.5},
      {-44.5, -40, 3, 6, -4.5},
      // without a rest length
      {3.5, 1, 4, 0, -10},
      {1, 3.5, 4, 0, 10},
      {-0.25, -0.5, 4, 0, -1},
      // at rest
      {5, 3.5, 100, 1.5, 0},
      {3.5, 5, 100, 1.5, 0},
      // the ends of what may be asked
      {1000, -1000, 1e9, 1000, -1e12},
      {-1000, 1000, 1e9, 0, 2e12},
      {250, -250.5, 1e-3, 1000, 0.4995},
      {-250.5, 250, 1e-3, 1000, -0.4995},
      {0.5, 0.25, 1e-3, 0, -2.5e-4},
      {1000, 999.5, 1e9, 1000, 9.995e11},
  };
  for (const ForceRow& r : rows) {
    const double L = std::abs(r.xa - r.xb);
    if (!close(f(r.xa, r.xb, r.k, r.L0), r.force, eps * r.k * (L + r.L0))) return false;
  }
  return true;
}

bool forceEdges(const SpringForce& f) {
  for (const double x : {0.0, 1.0, -3.5, 1000.0}) {
    for (const double L0 : {0.0, 0.5, 2.0, 1000.0}) {
      if (!close(f(x, x, 10, L0), 0, 0)) return false;
    }
  }
  for (int n = 1; n <= 100; ++n) {
    const double L = 1.5 * std::pow(10.0, -n);
    const double push = 10 * (2 - L);
    if (!close(f(L, 0, 10, 2), push, eps * 10 * (L + 2))) return false;
    if (!close(f(0, L, 10, 2), -push, eps * 10 * (L + 2))) return false;
    if (!close(f(L, 0, 10, 0), -10 * L, eps * 10 * L)) return false;
  }
  return true;
}

bool energyTable(const SpringEnergy& energy, const EnergyGradient& gradient) {
  const std::vector<EnergyRow> rows = {
      {{3, 0, 4}, {0, 0, 0}, 10, 3, 5, 20, {12, 0, 16}},
      {{0, 0, 0}, {3, 0, 4}, 10, 3, 5, 20, {-12, 0, -16}},
      {{1, 2, 2}, {0, 0, 0}, 4, 1, 3, 8, {8.0 / 3, 16.0 / 3, 16.0 / 3}},
      {{3, -1, 9}, {1, 2, 3}, 14, 5.5, 7, 15.75, {6, -9, 18}},
      {{1, 2, 3}, {3, -1, 9}, 14, 5.5, 7, 15.75, {-6, 9, -18}},
      // compressed
      {{3, 0, 4}, {0, 0, 0}, 10, 7, 5, 20, {-12, 0, -16}},
      {{3, -1, 9}, {1, 2, 3}, 14, 8, 7, 7, {-4, 6, -12}},
      {{1, 2, 3}, {3, -1, 9}, 14, 8, 7, 7, {4, -6, 12}},
      {{0.25, 0.5, -0.5}, {0, 0, 0}, 6, 2, 0.75, 4.6875, {-2.5, -5, 5}},
      {{0, 0, 0}, {0.25, 0.5, -0.5}, 6, 2, 0.75, 4.6875, {2.5, 5, -5}},
      // along the axes, through the origin
      {{0.5, 0, 0}, {-2, 0, 0}, 2, 1, 2.5, 2.25, {3, 0, 0}},
      {{0, -2, 0}, {0, 0.5, 0}, 2, 1, 2.5, 2.25, {0, -3, 0}},
      {{7, 7, 7.5}, {7, 7, 7}, 2, 2.5, 0.5, 4, {0, 0, -4}},
      // without a rest length
      {{1, 2, 2}, {-1, -1, -4}, 3, 0, 7, 73.5, {6, 9, 18}},
      // at rest
      {{1, 2, 2}, {-1, -1, -4}, 3, 7, 7, 0, {0, 0, 0}},
      // the ends of what may be asked
      {{600, 0, -800}, {0, 0, 0}, 1e9, 1000, 1000, 0, {0, 0, 0}},
      {{600, 0, -800}, {-600, 0, 800}, 1e9, 1000, 2000, 5e14, {6e11, 0, -8e11}},
      {{600, 0, -800}, {0, 0, 0}, 1e-3, 0, 1000, 500, {0.6, 0, -0.8}},
      {{0.5, 0, 0}, {0.5, 0.5, 0}, 1e-3, 1, 0.5, 1.25e-4, {0, 5e-4, 0}},
  };
  for (const EnergyRow& r : rows) {
    const Vec6 x = stack(r.xa, r.xb);
    const double size = r.L + r.L0;
    if (!close(energy(x, r.k, r.L0), r.energy, eps * r.k * size * size)) return false;
    const Vec6 expected = stack(r.gradientA, -r.gradientA);
    if (!closeVector(gradient(x, r.k, r.L0), expected, eps * r.k * size)) return false;
  }
  return true;
}

bool energyEdges(const SpringEnergy& energy, const EnergyGradient& gradient) {
  for (const Vec3& here : {Vec3(0, 0, 0), Vec3(1, -2, 3.5)}) {
    for (const double L0 : {0.0, 0.5, 3.0}) {
      const Vec6 x = stack(here, here);
      if (!close(energy(x, 10, L0), 5 * L0 * L0, eps * 10 * L0 * L0)) return false;
      if (!closeVector(gradient(x, 10, L0), Vec6(Vec6::Zero()), 0)) return false;
    }
  }
  for (int n = 1; n <= 100; ++n) {
    const double L = 1.5 * std::pow(10.0, -n);
    const Vec3 u = n % 2 == 0 ? Vec3(0.6, 0, -0.8) : Vec3(0, -0.8, 0.6);
    const Vec6 x = stack(u * L, Vec3(0, 0, 0));
    if (!close(energy(x, 10, 2), 5 * (2 - L) * (2 - L), eps * 40)) return false;
    const Vec3 g = -10 * (2 - L) * u;
    if (!closeVector(gradient(x, 10, 2), stack(g, -g), eps * 20)) return false;
  }
  return true;
}

bool dampingTable(const ProjectedDamping& damping) {
  const std::vector<DampingRow> rows = {
      // parting and approaching, either node moving
      {{0, 0, 2}, {0, 0, 0}, {5, 0, 1}, {0, 0, 0}, 3, {0, 0, -3}},
      {{0, 0, 2}, {0, 0, 0}, {5, 0, -1}, {0, 0, 0}, 3, {0, 0, 3}},
      {{0, 0, 2}, {0, 0, 0}, {0, 0, 0}, {5, 0, 1}, 3, {0, 0, 3}},
      {{0, 0, 2}, {0, 0, 0}, {0, 0, 0}, {5, 0, -1}, 3, {0, 0, -3}},
      {{3, 4, 1}, {0, 0, 1}, {6, 8, 7}, {0, 0, 2}, 1, {-6, -8, 0}},
      {{0, 0, 1}, {3, 4, 1}, {0, 0, 2}, {6, 8, 7}, 1, {6, 8, 0}},
      // a - b = (2, -3, 6) is 7 long; the velocities differ by (1, 1, 4): the length grows by 23/7
      {{3, -1, 9}, {1, 2, 3}, {1.5, 3, 2}, {0.5, 2, -2}, 49, {-46, 69, -138}},
      {{3, -1, 9}, {1, 2, 3}, {0.5, 2, -2}, {1.5, 3, 2}, 49, {46, -69, 138}},
      {{1, 2, 3}, {3, -1, 9}, {1.5, 3, 2}, {0.5, 2, -2}, 49, {-46, 69, -138}},
      // shorter than a metre: (0.25, 0.5, -0.5) is 0.75 long
      {{0.25, 0.5, -0.5}, {0, 0, 0}, {3, 0, 0}, {0, -3, 0}, 3, {-3, -6, 6}},
      {{0.25, 0.5, -0.5}, {0, 0, 0}, {0, 0, 3}, {0, 0, 0}, 3, {2, 4, -4}},
      // across the spring, about each other, side by side
      {{1, 2, 3}, {3, -1, 9}, {3, 2, 0}, {0, 0, 0}, 5, {0, 0, 0}},
      {{1, 2, 3}, {3, -1, 9}, {3, 2, 0}, {-3, -2, 0}, 5, {0, 0, 0}},
      {{1, 2, 3}, {3, -1, 9}, {3, 2, 7}, {3, 2, 7}, 5, {0, 0, 0}},
      // no damping, and the ends of what may be asked
      {{1, 2, 3}, {3, -1, 9}, {3, 5, 7}, {-1, 0, 2}, 0, {0, 0, 0}},
      {{600, -800, 0}, {-600, 800, 0}, {600, -800, 0}, {-600, 800, 0}, 1e6, {-1.2e9, 1.6e9, 0}},
      {{1000, 0, 0}, {-1000, 0, 0}, {-1000, 0, 3}, {1000, 0, 0}, 1e6, {2e9, 0, 0}},
      {{3, 4, 1}, {0, 0, 1}, {6e-6, 8e-6, 0}, {0, 0, 0}, 1, {-6e-6, -8e-6, 0}},
      {{3, 4, 1}, {0, 0, 1}, {6, 8, 7}, {0, 0, 2}, 1e-6, {-6e-6, -8e-6, 0}},
      {{500, 500, 500}, {502, 497, 506}, {1, 1, 4}, {0, 0, 0}, 49, {-46, 69, -138}},
  };
  for (const DampingRow& r : rows) {
    const double size = r.d * (r.va - r.vb).norm();
    if (!closeVector(damping(r.xa, r.xb, r.va, r.vb, r.d), r.force, eps * size)) return false;
  }
  return true;
}

bool dampingEdges(const ProjectedDamping& damping) {
  for (const Vec3& here : {Vec3(0, 0, 0), Vec3(1, -2, 3.5)}) {
    if (!closeVector(damping(here, here, Vec3(1, 2, 3), Vec3(-1, 0, 1), 2), Vec3(0, 0, 0), 0)) return false;
    if (!closeVector(damping(here, here, Vec3(1, 2, 3), Vec3(1, 2, 3), 2), Vec3(0, 0, 0), 0)) return false;
    if (!closeVector(damping(here, here, Vec3(0, 0, 0), Vec3(0, 4, 0), 1e6), Vec3(0, 0, 0), 0)) return false;
  }
  for (int n = 1; n <= 100; ++n) {
    const double L = 1.5 * std::pow(10.0, -n);
    const Vec3 xa(0.6 * L, 0, -0.8 * L), xb(0, 0, 0);
    if (!closeVector(damping(xa, xb, Vec3(5, 3, 0), Vec3(0, 1, 0), 2), Vec3(-3.6, 0, 4.8), 5e-8)) return false;
    if (!closeVector(damping(xb, xa, Vec3(5, 3, 0), Vec3(0, 1, 0), 2), Vec3(-3.6, 0, 4.8), 5e-8)) return false;
    if (!closeVector(damping(xa, xb, Vec3(0, 1, 0), Vec3(5, 3, 0), 2), Vec3(3.6, 0, -4.8), 5e-8)) return false;
  }
  return true;
}

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  try {
    return forceTable(springForceOnA) && forceEdges(springForceOnA);
  } catch (const std::exception&) {
    return false;
  }
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  try {
    return energyTable(springEnergy, energyGradient) && energyEdges(springEnergy, energyGradient);
  } catch (const std::exception&) {
    return false;
  }
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  try {
    return dampingTable(projectedDamping) && dampingEdges(projectedDamping);
  } catch (const std::exception&) {
    return false;
  }
}

#include "reference/cloth.h"

#include "reference/gragg_bulirsch_stoer.h"

#include <cmath>

namespace muelle::hard_cases {

namespace {

using Long = long double;
using LongVector = std::vector<Long>;

constexpr int clothSide = 10, clothNodes = clothSide * clothSide;
constexpr Long nodeMass = 0.001L, threadDamping = 0.01L, gridSpacing = 0.1L;

struct Thread {
  std::size_t a, b;  ///< first unknowns of its two nodes
  Long L0;
};

std::size_t firstUnknown(int i, int j) { return static_cast<std::size_t>(3 * (clothSide * j + i)); }

std::vector<Thread> threads() {
  std::vector<Thread> all;
  const Long diagonal = gridSpacing * std::sqrt(2.0L);
  for (int j = 0; j < clothSide; ++j) {
    for (int i = 0; i < clothSide; ++i) {
      if (i + 1 < clothSide) all.push_back({firstUnknown(i, j), firstUnknown(i + 1, j), gridSpacing});
      if (j + 1 < clothSide) all.push_back({firstUnknown(i, j), firstUnknown(i, j + 1), gridSpacing});
      if (i + 1 == clothSide || j + 1 == clothSide) continue;
      all.push_back({firstUnknown(i, j), firstUnknown(i + 1, j + 1), diagonal});
      all.push_back({firstUnknown(i + 1, j), firstUnknown(i, j + 1), diagonal});
    }
  }
  return all;
}

/// y: the positions of all nodes, then their velocities; the corners 0 and 9 do not move.
void clothSlope(const std::vector<Thread>& all, Long k, const LongVector& y, LongVector& slope) {
  constexpr std::size_t n = 3 * clothNodes;
  for (std::size_t i = 0; i < n; ++i) {
    slope[i] = y[n + i];
    slope[n + i] = i % 3 == 2 ? -9.81L : 0.0L;
  }
  for (const Thread& s : all) {
    Long d[3], squared = 0, rate = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      d[c] = y[s.b + c] - y[s.a + c];
      squared += d[c] * d[c];
      rate += d[c] * (y[n + s.b + c] - y[n + s.a + c]);
    }
    const Long L = std::sqrt(squared), pull = (k * (L - s.L0) + threadDamping * rate / L) / (L * nodeMass);
    for (std::size_t c = 0; c < 3; ++c) {
      slope[n + s.a + c] += pull * d[c];
      slope[n + s.b + c] -= pull * d[c];
    }
  }
  for (const int corner : {0, clothSide - 1}) {
    for (std::size_t c = 0; c < 3; ++c) slope[n + static_cast<std::size_t>(3 * corner) + c] = 0;
  }
}

Long clothEnergy(const std::vector<Thread>& all, Long k, const LongVector& y) {
  constexpr std::size_t n = 3 * clothNodes;
  Long energy = 0;
  for (std::size_t i = 0; i < n; ++i)
    energy += 0.5L * nodeMass * y[n + i] * y[n + i] + (i % 3 == 2 ? 9.81L * nodeMass * y[i] : 0);
  for (const Thread& s : all) {
    const Long stretch = std::hypot(y[s.b] - y[s.a], y[s.b + 1] - y[s.a + 1], y[s.b + 2] - y[s.a + 2]) - s.L0;
    energy += 0.5L * k * stretch * stretch;
  }
  return energy;
}

}  // namespace

std::vector<long double> clothAfter(long double k, long double duration, long double tolerance) {
  const std::vector<Thread> all = threads();
  LongVector y(6 * clothNodes, 0);
  for (int j = 0; j < clothSide; ++j) {
    for (int i = 0; i < clothSide; ++i) {
      y[firstUnknown(i, j)] = gridSpacing * i;
      y[firstUnknown(i, j) + 1] = gridSpacing * j;
    }
  }
  const SlopeOf<Long> slope = [&](Long, const LongVector& at, LongVector& f) { clothSlope(all, k, at, f); };
  y = integrate(slope, y, 0.0L, duration, tolerance);
  LongVector seven;
  for (const std::size_t node : {44U, 99U}) seven.insert(seven.end(), {y[3 * node], y[3 * node + 1], y[3 * node + 2]});
  seven.push_back(clothEnergy(all, k, y));
  return seven;
}

}  // namespace muelle::hard_cases

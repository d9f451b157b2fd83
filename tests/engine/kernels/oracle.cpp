#include "oracle.h"

#include "engine/kernels/grid_search.h"
#include "engine/kernels/grid_springs.h"
#include "engine/kernels/spring_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace muelle::engine::kernels {

namespace {

struct SpringForce {
  long double F[3] = {};
  double bound = 0.0;
};

/// Each operation of the loops errs by at most u = 2^-53 of its result. With d = xa - xb exact to one u a component:
/// L to 3 u (square of d: 3 u for product and difference, two sums: 2 u, halved by the root, and its own u: (5 / 2 + 1)
/// u), so k (L0 - L) errs by k (3.5 L + 2 |L0 - L|) u; the projected speed by (7 + 3) u dProjected |w|; division and
/// the product with d, which has its own u, add at most (3.5 + 5) u of the whole; the relative part 3 u dRelative |w|.
/// Altogether below 16 u (k (L + |L0 - L|) + (dRelative + dProjected) |w|), and as much again where 1 / L is formed.
SpringForce forceOf(const SpringData& s, const Nodes& nodes) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  const auto a = static_cast<std::size_t>(s.a), b = static_cast<std::size_t>(s.b);
  long double d[3] = {}, w[3] = {}, largest = 0.0L, speed = 0.0L, relative = 0.0L;
  for (std::size_t c = 0; c < D; ++c) {
    d[c] = static_cast<long double>(nodes.x[D * a + c]) - nodes.x[D * b + c];
    w[c] = static_cast<long double>(nodes.v[D * a + c]) - nodes.v[D * b + c];
    largest = std::max(largest, std::fabs(d[c]));
  }
  const long double L = std::hypot(d[0], d[1], d[2]), speedAll = std::hypot(w[0], w[1], w[2]);
  SpringForce force;
  for (std::size_t c = 0; c < D && L > 0.0L; ++c) speed += w[c] * (d[c] / L);
  relative = s.dRelative;
  if (nodes.dimension == 1 && !(L > 0.0L)) relative += s.dProjected;  // one damping, at zero length too
  for (std::size_t c = 0; c < D; ++c) {
    const long double n = L > 0.0L ? d[c] / L : 0.0L;
    force.F[c] = (s.k * (s.L0 - L) - s.dProjected * speed) * n - relative * w[c];
  }
  const long double u = 0.5L * std::numeric_limits<double>::epsilon();
  force.bound =
      static_cast<double>(32.0L * u * (s.k * (L + std::fabs(s.L0 - L)) + (s.dRelative + s.dProjected) * speedAll));
  return force;
}

template <class Visit>
void eachEnd(const Nodes& nodes, const std::vector<SpringData>& springs, Visit visit) {
  for (const SpringData& s : springs) {
    const SpringForce force = forceOf(s, nodes);
    visit(s.a, force, 1.0L);
    visit(s.b, force, -1.0L);
  }
}

}  // namespace

std::vector<long double> oracleForces(const Nodes& nodes, const std::vector<SpringData>& springs) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  std::vector<long double> f(nodes.x.size(), 0.0L);
  eachEnd(nodes, springs, [&](int node, const SpringForce& force, long double sign) {
    for (std::size_t c = 0; c < D; ++c) f[D * static_cast<std::size_t>(node) + c] += sign * force.F[c];
  });
  return f;
}

/// The springs' own bounds, and for each sum one u of the largest partial sum, at most that of all sizes.
std::vector<double> roundingBounds(const Nodes& nodes, const std::vector<SpringData>& springs) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  const double u = 0.5 * std::numeric_limits<double>::epsilon();
  std::vector<double> own(nodes.x.size(), 0.0), sizes(nodes.x.size(), 0.0), sums(nodes.x.size(), 0.0);
  eachEnd(nodes, springs, [&](int node, const SpringForce& force, long double) {
    for (std::size_t c = 0; c < D; ++c) {
      const std::size_t i = D * static_cast<std::size_t>(node) + c;
      own[i] += force.bound;
      sizes[i] += static_cast<double>(std::fabs(force.F[c]));
      sums[i] += 1.0;
    }
  });
  for (std::size_t i = 0; i < own.size(); ++i) own[i] += u * sums[i] * sizes[i] * 1.001;
  return own;
}

std::vector<double> generalForces(const Nodes& nodes, const std::vector<SpringData>& springs) {
  const auto D = static_cast<std::size_t>(nodes.dimension), lanes = D == 3 ? 4 : D;
  std::vector<double> x(lanes * nodes.count()), v(x.size()), f(x.size()), result(nodes.x.size());
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    x[i / D * lanes + i % D] = nodes.x[i];
    v[i / D * lanes + i % D] = nodes.v[i];
  }
  const SpringGroups groups(nodes.dimension, static_cast<int>(nodes.count()), springs);
  groups.addForce(x.data(), v.data(), f.data());
  for (std::size_t i = 0; i < nodes.x.size(); ++i) result[i] = f[i / D * lanes + i % D];
  for (std::size_t i = 3; D == 3 && i < f.size(); i += 4) EXPECT_EQ(f[i], 0.0) << "padding of node " << i / 4;
  return result;
}

Nodes randomNodes(int dimension, int count, Dice& dice) {
  Nodes nodes;
  nodes.dimension = dimension;
  for (int i = 0; i < dimension * count; ++i) {
    nodes.x.push_back(3.0 * dice.number());
    nodes.v.push_back(2.0 * dice.number());
  }
  return nodes;
}

SpringData springOf(int a, int b, Damping damping, Dice& dice) {
  SpringData s = {a, b, 100.0 + dice.roll(1000), 0.25 * dice.roll(8), 0.0, 0.0};
  if (damping == Damping::Relative || damping == Damping::Both) s.dRelative = 0.5 + dice.roll(5);
  if (damping == Damping::Projected || damping == Damping::Both) s.dProjected = 0.25 + dice.roll(7);
  return s;
}

std::vector<SpringData> clothSprings(int n, Damping damping, Dice& dice) {
  std::vector<SpringData> springs;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (const auto& [down, right] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}, {2, 0}, {0, 2}}) {
        if (i + down >= n || j + right >= n || j + right < 0) continue;
        springs.push_back(springOf(i * n + j, (i + down) * n + j + right, damping, dice));
      }
    }
  }
  return springs;
}

std::vector<double> gridForces(const Nodes& nodes, const std::vector<SpringData>& springs, std::size_t block,
                               Precision precision) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  GridSearch found = findRuns(nodes.dimension, nodes.count(), springs);
  EXPECT_TRUE(found.isGrid()) << found.refusal;
  const GridSprings grid(nodes.dimension, nodes.count(), found.runs, found.loose, block, precision);
  PlanarCase planar(nodes);
  grid.evaluate(planar.state(), planar.finish());
  std::vector<double> result(nodes.x.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = planar.at(i / D, i % D);
  for (std::size_t c = 0; c < D; ++c) {
    for (std::size_t i = nodes.count(); i < planar.plane; ++i) EXPECT_EQ(planar.at(i, c), 0.0) << "padding " << i;
  }
  return result;
}

bool areSame(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

PlanarCase::PlanarCase(const Nodes& nodes) : plane(planeFor(nodes.count())) {
  const auto D = static_cast<std::size_t>(nodes.dimension);
  x.resize(D * plane);
  v.resize(D * plane);
  out.assign(D * plane, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    x[i % D * plane + i / D] = nodes.x[i];
    v[i % D * plane + i / D] = nodes.v[i];
  }
}

}  // namespace muelle::engine::kernels

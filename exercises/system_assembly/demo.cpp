#include "harness/demo.h"

#include "system_assembly.h"

#include <memory>

// How many questions one gradient takes for nets of more and more nodes; and a rope between two heavy ends that is let
// go. What a spring does is given to your functions; here it is a bar that measures its stretch without a square root.

namespace {

using muelle::In;
using muelle::Out;
using Numbers = std::vector<double>;

double barEnergy(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double stretch = (xa - xb).squaredNorm() / (L0 * L0) - 1;
  return k * L0 * L0 / 8 * stretch * stretch;
}

Vec6 barGradient(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  Vec6 both;
  both << r, -r;
  return k / 2 * (r.squaredNorm() / (L0 * L0) - 1) * both;
}

struct Body {
  VecX x, m;
  std::vector<Spring> springs;

  int nodes() const { return static_cast<int>(m.size()); }
};

/// So many nodes a side, with springs along both sides and both diagonals of each square.
Body net(int side) {
  constexpr double spacing = 0.1;
  Body body{VecX(3 * side * side), VecX::Constant(side * side, 0.02), {}};
  const auto join = [&](int i, int j, int otherI, int otherJ) {
    if (otherI < side && otherJ < side && otherJ >= 0) {
      const double L0 = spacing * std::hypot(otherI - i, otherJ - j);
      body.springs.push_back({side * i + j, side * otherI + otherJ, 40, L0});
    }
  };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      body.x.segment<3>(3 * (side * i + j)) = Vec3(spacing * i, spacing * j, 0);
      join(i, j, i + 1, j);
      join(i, j, i, j + 1);
      join(i, j, i + 1, j + 1);
      join(i, j, i + 1, j - 1);
    }
  }
  return body;
}

double questionsOf(const Body& body) {
  const auto asked = std::make_shared<int>(0);
  submission::systemGradient(body.x, body.springs, [asked](const Vec3& xa, const Vec3& xb, double k, double L0) {
    ++*asked;
    return barGradient(xa, xb, k, L0);
  });
  return *asked;
}

muelle::Figure cost() {
  Numbers nodes, questions, each, nested;
  for (const int side : {2, 3, 5, 7, 10}) {
    const Body body = net(side);
    const auto springs = static_cast<double>(body.springs.size());
    nodes.push_back(body.nodes());
    questions.push_back(questionsOf(body));
    each.push_back(springs);
    nested.push_back(springs * body.nodes());
  }
  muelle::Figure figure("cost", "Questions for one gradient of a net", "nodes");
  figure.logX();
  figure.panel("questions")
      .logY()
      .linePoints("systemGradient", nodes, questions)
      .line("each spring, for each node", nodes, nested)
      .reference("each spring once", nodes, each);
  return figure;
}

constexpr double g = 9.81;        // [m/s^2]
constexpr double anchored = 1e6;  // mass of the two ends [kg]: they hardly move

/// Nodes on a line of 1 m, with a bar between neighbours.
Body rope(int nodes) {
  Body body{VecX::Zero(3 * nodes), VecX::Constant(nodes, 0.3 / nodes), {}};
  for (int i = 0; i < nodes; ++i) {
    body.x[3 * i] = i / (nodes - 1.0);
    if (i > 0) body.springs.push_back({i - 1, i, 25.0 * (nodes - 1), 1 / (nodes - 1.0)});
  }
  body.m[0] = body.m[nodes - 1] = anchored;
  return body;
}

/// Gravity on the nodes that are not anchored.
VecX weights(const Body& body) {
  VecX F = VecX::Zero(body.x.size());
  for (int i = 1; i + 1 < body.nodes(); ++i) F[3 * i + 2] = -body.m[i] * g;
  return F;
}

VecX vectorOf(In numbers) { return Eigen::Map<const VecX>(numbers.data(), static_cast<Eigen::Index>(numbers.size())); }

/// Half of v M v with the student's M, or nothing where its size is another.
muelle::Probe kineticEnergyOf(const SparseMatrix& M) {
  return {"kinetic energy", "J", [&M](const muelle::State& state) {
            const VecX v = vectorOf(state.v);
            return M.rows() == v.size() && M.cols() == v.size() ? 0.5 * v.dot(M * v) : NAN;
          }};
}

muelle::Trajectory swing(const Body& body) {
  const VecX F = weights(body);
  const SparseMatrix M = submission::systemMassMatrix(body.m);
  Numbers masses;
  for (Eigen::Index i = 0; i < body.x.size(); ++i) masses.push_back(body.m[i / 3]);
  const muelle::FunctionSystem system(masses, [&](double, In x, In, Out f) {
    const VecX a = submission::systemAccelerations(vectorOf(x), body.m, body.springs, barGradient, F);
    for (std::size_t i = 0; i < f.size(); ++i) {
      f[i] = a.size() == body.x.size() ? masses[i] * a[static_cast<Eigen::Index>(i)] : 0.0;
    }
  });
  const muelle::Probe elastic{"elastic energy", "J", [&](const muelle::State& state) {
                                return submission::systemEnergy(vectorOf(state.x), body.springs, barEnergy);
                              }};
  const muelle::Probe weight{"energy of weight", "J",
                             [&](const muelle::State& state) { return -F.dot(vectorOf(state.x)); }};
  const muelle::Probe kinetic = kineticEnergyOf(M);
  muelle::MarchOptions options;
  options.h = 5e-3;
  options.duration = 1.5;
  options.dimension = 3;
  options.probes = {kinetic, elastic, weight, muelle::sum("total energy", {kinetic, elastic, weight})};
  return march(system, {0.0, {body.x.begin(), body.x.end()}, Numbers(masses.size(), 0.0), {}}, options);
}

muelle::Figure energies(const muelle::Trajectory& run) {
  muelle::Figure figure("energy", "Energies of a rope that is let go", "time [s]");
  figure.panel("energy [J]")
      .line("kinetic", run.t, run.track("kinetic energy"))
      .line("elastic", run.t, run.track("elastic energy"))
      .line("of weight", run.t, run.track("energy of weight"))
      .line("total", run.t, run.track("total energy"))
      .expect(-0.5, 0.5);
  return figure;
}

muelle::Figure shapes(const muelle::Trajectory& run, const Body& body) {
  muelle::Figure figure("shape", "Shapes of a rope that is let go", "x [m]");
  auto panel = figure.panel("z [m]");
  panel.expectX(0.0, 1.0).expect(-0.5, 0.1);
  for (std::size_t frame = 0; frame < run.t.size() && frame <= 60; frame += 15) {
    Numbers x, z;
    for (int i = 0; i < body.nodes(); ++i) {
      x.push_back(run.x[frame][static_cast<std::size_t>(3 * i)]);
      z.push_back(run.x[frame][static_cast<std::size_t>(3 * i + 2)]);
    }
    panel.linePoints("at t = " + std::to_string(std::lround(1000 * run.t[frame])) + " ms", x, z);
  }
  return figure;
}

}  // namespace

MUELLE_DEMO {
  const Body body = rope(12);
  const muelle::Trajectory run = swing(body);
  return {cost(), energies(run), shapes(run, body)};
}

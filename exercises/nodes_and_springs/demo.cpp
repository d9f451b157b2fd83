#include "harness/demo.h"

#include "nodes_and_springs.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

// The lecture's rabbit, squeezed between two plates and at rest; how often the two programs ask the law of the springs;
// and a net that flies, once by the one program and once by the other.

namespace {

using muelle::In;
using muelle::Out;
using Numbers = std::vector<double>;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Bars that measure their stretch without a square root, by (L/L0)^2 - 1.
Vec3 barForce(const Vec3& xa, const Vec3& xb, double stiffness, double length) {
  const Vec3 r = xa - xb;
  return -0.5 * stiffness * (r.squaredNorm() / (length * length) - 1) * r;
}

struct Net {
  std::vector<NodeData> nodes;
  std::vector<SpringData> springs;
};

Net rabbitInHand() {
  std::ifstream file(MUELLE_EXERCISE_FOLDER "/rabbit_at_rest.txt");
  std::stringstream text;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with('#')) text << line << '\n';
  }
  std::size_t nodes = 0, springs = 0;
  text >> nodes >> springs;
  Net net;
  for (NodeData n{}; net.nodes.size() < nodes && text >> n.mass >> n.x[0] >> n.x[1] >> n.x[2];) net.nodes.push_back(n);
  for (SpringData s{}; net.springs.size() < springs && text >> s.a >> s.b >> s.stiffness >> s.length;)
    net.springs.push_back(s);
  if (nodes == 0 || net.springs.size() < springs) throw std::runtime_error("rabbit_at_rest.txt is not whole");
  return net;
}

/// From the side: the springs of its near side, and at each node an arrow for the sum of the spring forces.
muelle::Figure atRest() {
  constexpr double metresPerNewton = 0.02;
  const Net rabbit = rabbitInHand();
  const std::vector<Result> results = submission::scatter(rabbit.nodes, rabbit.springs, barForce);
  Numbers x, z, dx, dz, springX, springZ;
  for (std::size_t i = 0; i < std::min(results.size(), rabbit.nodes.size()); ++i) {
    x.push_back(rabbit.nodes[i].x[0]);
    z.push_back(rabbit.nodes[i].x[2]);
    dx.push_back(metresPerNewton * results[i].F[0]);
    dz.push_back(metresPerNewton * results[i].F[2]);
  }
  const auto at = [&rabbit](int node) { return rabbit.nodes[static_cast<std::size_t>(node)].x; };
  for (const SpringData& s : rabbit.springs) {
    if (at(s.a)[1] + at(s.b)[1] > 0) continue;  // the far side
    springX.insert(springX.end(), {at(s.a)[0], at(s.b)[0], gap});
    springZ.insert(springZ.end(), {at(s.a)[2], at(s.b)[2], gap});
  }
  muelle::Figure figure("rest", "The squeezed rabbit at rest: sum of the spring forces at each node, 2 cm a newton",
                        "x [m]");
  figure.equalAxes();
  figure.panel("z [m]")
      .expectX(-0.1, 0.1)
      .expect(-0.03, 0.18)
      .mesh("springs", springX, springZ)
      .reference("plates", {-0.1, 0.1, gap, -0.1, 0.1}, {0.0, 0.0, gap, 0.145, 0.145})
      .arrows("sum of spring forces", x, z, dx, dz);
  return figure;
}

/// A row of nodes with a spring between neighbours.
Net chain(int springs) {
  Net net;
  for (int i = 0; i <= springs; ++i) net.nodes.push_back({0.1, Vec3(0.12 * i, 0, 0)});
  for (int i = 0; i < springs; ++i) net.springs.push_back({i, i + 1, 50, 0.1});
  return net;
}

/// How often a program asks the law.
template <class Program>
double questions(const Program& program, const Net& net) {
  const auto asked = std::make_shared<int>(0);
  program(net.nodes, net.springs, [asked](const Vec3& xa, const Vec3& xb, double stiffness, double length) {
    ++*asked;
    return barForce(xa, xb, stiffness, length);
  });
  return *asked;
}

muelle::Figure questionsBySprings() {
  Numbers springs, gathering, scattering;
  for (int count = 0; count <= 40; count += 5) {
    const Net net = chain(count);
    springs.push_back(count);
    gathering.push_back(questions(submission::gather, net));
    scattering.push_back(questions(submission::scatter, net));
  }
  muelle::Figure figure("questions", "How often a program asks the law of the springs", "number of springs");
  figure.panel("questions")
      .linePoints("gather", springs, gathering)
      .linePoints("scatter", springs, scattering)
      .expect(0, 80);
  return figure;
}

/// A frame with two diagonals, thrown up; under the weight it falls, and its springs make it tremble.
template <class Program>
muelle::Trajectory fly(const Program& program) {
  constexpr double m = 0.2, g = 9.81;
  const std::vector<SpringData> springs = {{0, 1, 60, 0.5}, {1, 2, 60, 0.4}, {2, 3, 60, 0.5},
                                           {3, 0, 60, 0.4}, {0, 2, 40, 0.6}, {1, 3, 40, 0.6}};
  const muelle::FunctionSystem system(Numbers(12, m), [&springs, &program](double, In x, In, Out f) {
    std::vector<NodeData> nodes;
    for (std::size_t i = 0; i < 4; ++i) nodes.push_back({m, Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2])});
    const std::vector<Result> results = program(nodes, springs, barForce);
    for (std::size_t i = 0; i < std::min<std::size_t>(4, results.size()); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        f[3 * i + axis] = m * results[i].a[static_cast<Eigen::Index>(axis)] - (axis == 2 ? m * g : 0.0);
      }
    }
  });
  muelle::State start;
  start.x = {0, 0, 0, 0.5, 0, 0, 0.5, 0, 0.4, 0, 0, 0.4};
  start.v = {0.9, 0, 1.8, 0.9, 0, 4.8, -0.3, 0, 4.4, -0.3, 0, 2.6};
  muelle::MarchOptions options;
  options.h = 2e-3;
  options.duration = 0.7;
  options.outputEvery = 5;
  return march(system, start, options);
}

Numbers averageHeight(const muelle::Trajectory& run) {
  Numbers heights;
  for (const Numbers& x : run.x) heights.push_back((x[2] + x[5] + x[8] + x[11]) / 4);
  return heights;
}

muelle::Figure flight() {
  const muelle::Trajectory gathered = fly(submission::gather), scattered = fly(submission::scatter);
  muelle::Figure figure("flight", "A frame of four nodes is thrown", "time [s]");
  figure.panel("height of node 1 [m]")
      .line("gather", gathered.t, gathered.position(5))
      .line("scatter", scattered.t, scattered.position(5))
      .expect(-0.5, 1.5);
  figure.panel("mean height [m]")
      .line("gather", gathered.t, averageHeight(gathered))
      .line("scatter", scattered.t, averageHeight(scattered))
      .expect(-0.5, 1.5);
  return figure;
}

}  // namespace

MUELLE_DEMO { return {atRest(), questionsBySprings(), flight()}; }

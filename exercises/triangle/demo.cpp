#include "harness/demo.h"
#include "triangle.h"

// A triangle with unequal masses and springs is thrown into empty space. Nothing acts on it but its own springs.

namespace {

using muelle::In;
using muelle::Out;

const Vec3 m(0.4, 0.6, 0.5);      // [kg]
const Vec3 k(60, 45, 80);         // [N/m], springs 01, 12, 20
const Vec3 L0(1.1, 1.2, 1.0);     // [m]
constexpr double duration = 2.0;  // [s]

Vec9 stackedAt(In x) { return Eigen::Map<const Vec9>(x.data()); }

muelle::Trajectory fly() {
  const Mat9 M = submission::massMatrix(m);
  std::vector<double> mass;
  // The simulation needs positive masses: where the mass matrix has none yet, the given ones keep it going.
  for (int i = 0; i < 9; ++i) mass.push_back(M(i, i) > 0 ? M(i, i) : m[i / 3]);
  const muelle::FunctionSystem system(mass, [](double, In x, In, Out f) {
    const Vec9 F = submission::triangleForce(stackedAt(x), k, L0);
    std::copy(F.begin(), F.end(), f.begin());
  });
  const muelle::Probe elastic{"elastic energy", "J", [](const muelle::State& state) {
                                return submission::triangleEnergy(stackedAt(state.x), k, L0);
                              }};
  const muelle::Probe kinetic = kineticEnergy(system);
  muelle::State start;
  start.x = {-0.6, -0.3, 0.0, 0.7, -0.4, 0.0, 0.1, 0.7, 0.0};
  start.v = {1.9, -1.6, 0.2, 2.2, 2.3, -0.1, -1.1, 0.5, 0.3};  // 3 rad/s about z, and a drift
  muelle::MarchOptions options;
  options.h = 1e-3;
  options.duration = duration;
  options.outputEvery = 4;
  options.probes = {kinetic, elastic, muelle::sum("total energy", {kinetic, elastic})};
  for (int axis = 0; axis < 3; ++axis) {
    options.probes.push_back(linearMomentum(system, axis));
    options.probes.push_back(angularMomentum(system, axis));
  }
  return march(system, start, options);
}

/// The tracks of the momentum along x, y, z, in the order in which fly() asks for them.
const std::vector<double>& momentum(const muelle::Trajectory& run, bool angular, std::size_t axis) {
  return run.tracks.at(3 + 2 * axis + (angular ? 1 : 0)).values;
}

muelle::Figure energies(const muelle::Trajectory& run) {
  muelle::Figure figure("energy", "Free flight: energies", "time [s]");
  figure.panel("energy [J]")
      .line("kinetic", run.t, run.track("kinetic energy"))
      .line("elastic", run.t, run.track("elastic energy"))
      .line("total", run.t, run.track("total energy"))
      .expect(0.0, 8.0);
  return figure;
}

muelle::Figure momenta(const muelle::Trajectory& run) {
  muelle::Figure figure("momenta", "Free flight: momenta", "time [s]");
  const char* names[] = {"x", "y", "z"};
  auto linear = figure.panel("linear [kg m/s]");
  linear.expect(0.0, 1.6);
  for (std::size_t axis = 0; axis < 3; ++axis) linear.line(names[axis], run.t, momentum(run, false, axis));
  auto angular = figure.panel("angular [kg m²/s]");
  angular.expect(0.0, 2.6);
  for (std::size_t axis = 0; axis < 3; ++axis) angular.line(names[axis], run.t, momentum(run, true, axis));
  return figure;
}

/// One coordinate of the centre of mass over time.
std::vector<double> centre(const muelle::Trajectory& run, int axis) {
  std::vector<double> values(run.t.size(), 0.0);
  for (int node = 0; node < 3; ++node) {
    const std::vector<double> x = run.position(3 * node + axis);
    for (std::size_t i = 0; i < x.size(); ++i) values[i] += m[node] / m.sum() * x[i];
  }
  return values;
}

muelle::Figure paths(const muelle::Trajectory& run) {
  muelle::Figure figure("paths", "Free flight: paths of the nodes and of their centre", "x [m]");
  figure.equalAxes();
  auto panel = figure.panel("y [m]");
  panel.expectX(-0.6, 2.9).expect(-0.5, 1.9);
  const char* names[] = {"node 0", "node 1", "node 2"};
  for (int node = 0; node < 3; ++node) panel.line(names[node], run.position(3 * node), run.position(3 * node + 1));
  panel.line("centre of mass", centre(run, 0), centre(run, 1));
  const std::vector<double>& start = run.x.front();
  panel.points("start", {start[0], start[3], start[6]}, {start[1], start[4], start[7]});
  return figure;
}

}  // namespace

MUELLE_DEMO {
  const muelle::Trajectory run = fly();
  return {energies(run), momenta(run), paths(run)};
}

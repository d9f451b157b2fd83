#include "harness/demo.h"
#include "contact.h"

#include <fmt/format.h>

// Balls that bounce on the ground, balls that fall on a sphere, and a column of nodes that lands and comes to rest.

namespace {

using muelle::In;
using muelle::node3;
using muelle::Out;
using muelle::State;

constexpr double g = 9.81;  // [m/s^2]
const Vec3 up = Vec3::UnitZ();
const Vec3 origin = Vec3::Zero();

// ---- Balls -----------------------------------------------------------------------------------------------------

/// Contact force on a node.
using Contact = std::function<Vec3(const Vec3& x, const Vec3& v)>;

/// A ball of 1 kg that is let go at `from` and hits something.
muelle::Trajectory drop(const Vec3& from, const Contact& contact, double h, double duration) {
  const muelle::FunctionSystem system({1.0, 1.0, 1.0}, [&contact](double, In x, In v, Out f) {
    node3(f, 0) = contact(node3(x, 0), node3(v, 0)) - g * up;
  });
  muelle::MarchOptions options;
  options.h = h;
  options.duration = duration;
  options.outputEvery = 3;
  options.probes = {muelle::sum(
      "energy", {muelle::kineticEnergy(system), {"weight", "J", [](const State& s) { return g * s.x[2]; }}})};
  return march(system, {0.0, {from.x(), from.y(), from.z()}, {0, 0, 0}, {}}, options);
}

muelle::Figure bounces() {
  const double k = 4000.0;
  const auto onGround = [k](double d) {
    return drop(
        up, [=](const Vec3& x, const Vec3& v) { return submission::planeContact(x, v, origin, up, k, d); }, 2e-3, 3.0);
  };
  const muelle::Trajectory elastic = onGround(0.0), damped = onGround(15.0);
  muelle::Figure figure("bounces", "Two balls fall on the ground", "time [s]");
  figure.panel("height [m]")
      .line("no damping", elastic.t, elastic.position(2))
      .line("with damping", damped.t, damped.position(2))
      .expect(-0.1, 1.0);
  figure.panel("kinetic energy and weight [J]")
      .line("no damping", elastic.t, elastic.track("energy"))
      .line("with damping", damped.t, damped.track("energy"))
      .expect(0.0, g);  // the weight of 1 kg at 1 m
  return figure;
}

muelle::Figure paths() {
  const double R = 0.5, k = 4000.0, d = 20.0;
  muelle::Figure figure("paths", "Balls fall on a sphere", "x [m]");
  figure.equalAxes();
  auto panel = figure.panel("z [m]");
  panel.expectX(-1.2, 1.0).expect(-1.2, 1.0);
  std::vector<double> startX, startZ;
  for (const double offset : {-0.4, 0.2, 0.45}) {
    const muelle::Trajectory run = drop(
        Vec3(offset, 0, 1),
        [=](const Vec3& x, const Vec3& v) { return submission::sphereContact(x, v, origin, R, k, d); }, 2e-3, 0.7);
    panel.line(fmt::format("{:g} m", offset), run.position(0), run.position(2));
    startX.push_back(offset);
    startZ.push_back(1.0);
  }
  std::vector<double> circleX, circleZ;
  for (int i = 0; i <= 90; ++i) {
    circleX.push_back(R * std::cos(i * M_PI / 45));
    circleZ.push_back(R * std::sin(i * M_PI / 45));
  }
  panel.points("start", startX, startZ).reference("sphere", circleX, circleZ);
  return figure;
}

// ---- A column --------------------------------------------------------------------------------------------------

const std::vector<double> mass(4, 0.2);  // [kg], bottom first
constexpr double k = 400.0;              // [N/m], each spring
constexpr double L0 = 0.3;               // [m]
constexpr double kPlane = 200.0;         // [N/m]
constexpr double dPlane = 8.0;           // [N s/m], near sqrt(k m): it swallows the waves that run down the column

/// The stiffness matrix of the springs of a column: forces are minus it, times the displacements.
muelle::MatX stiffnessMatrix() {
  muelle::MatX K = muelle::MatX::Zero(4, 4);
  for (int i = 0; i < 3; ++i) K.block<2, 2>(i, i) += k * (muelle::Mat2() << 1, -1, -1, 1).finished();
  return K;
}

muelle::Trajectory land() {
  const muelle::MatX K = stiffnessMatrix();
  const muelle::VecX undeformed = muelle::VecX::LinSpaced(4, 0.0, 3 * L0);
  const muelle::FunctionSystem system(mass, [&](double, In x, In v, Out f) {
    const Eigen::Map<const muelle::VecX> z(x.data(), 4);
    Eigen::Map<muelle::VecX> force(f.data(), 4);
    force = -K * (z - undeformed) - muelle::VecX::Constant(4, mass[0] * g);
    force[0] += submission::planeContact(z[0] * up, v[0] * up, origin, up, kPlane, dPlane).z();
  });
  State start;
  for (int i = 0; i < 4; ++i) start.x.push_back(0.1 + undeformed[i]);
  start.v.assign(4, 0.0);
  muelle::MarchOptions options;
  options.h = 2e-3;
  options.duration = 4.0;
  options.outputEvery = 3;
  return march(system, start, options);
}

muelle::Figure column() {
  const muelle::Trajectory run = land();
  const std::vector<double> rest = submission::columnAtRest(mass, k, L0, kPlane, g);
  muelle::Figure figure("column", "A column falls on the ground, and columnAtRest", "time [s]");
  auto panel = figure.panel("height [m]");
  panel.expect(-0.1, 1.0);
  for (int i = 0; i < 4; ++i) panel.line(fmt::format("node {}", i), run.t, run.position(i));
  panel.points("columnAtRest", std::vector<double>(rest.size(), run.t.back()), rest);
  return figure;
}

}  // namespace

MUELLE_DEMO { return {bounces(), column(), paths()}; }

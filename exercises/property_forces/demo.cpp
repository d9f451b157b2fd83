#include "harness/demo.h"
#include "property_forces.h"

// A class whose mean height is held while every pupil moves on a band of her own, one pupil who is raised by hand, and
// a class that flies apart in empty space and is held together by its spread.

namespace {

using muelle::In;
using muelle::Out;

VecX stackedAt(In x) { return Eigen::Map<const VecX>(x.data(), static_cast<Eigen::Index>(x.size())); }

/// Adds the student's force, as far as there is one.
void addTo(Out f, const VecX& force) {
  for (Eigen::Index i = 0; i < force.size() && i < static_cast<Eigen::Index>(f.size()); ++i) {
    f[static_cast<std::size_t>(i)] += force[i];
  }
}

std::vector<double> tripled(const VecX& m) {
  std::vector<double> mass;
  for (Eigen::Index i = 0; i < m.size(); ++i) mass.insert(mass.end(), 3, m[i]);
  return mass;
}

// --- the class ------------------------------------------------------------------------------------------------------

const VecX pupils = (VecX(5) << 31, 36, 42, 55, 78).finished();          // [kg]
const VecX places = (VecX(5) << 1.2, 2.9, 1.7, 2.6, 1.6).finished();     // [m], where their bands lead them
const VecX speeds = (VecX(5) << 2.0, -1.5, -2.2, 1.4, -0.6).finished();  // [m/s]
constexpr double target = 2.0;                                           // [m]
constexpr double band = 300.0;                                           // [N/m]
constexpr double stiffness = 9000.0;                                     // [N/m], of the mean height

muelle::Trajectory jump() {
  const muelle::FunctionSystem system(tripled(pupils), [](double, In x, In, Out f) {
    std::fill(f.begin(), f.end(), 0.0);
    for (int i = 0; i < 5; ++i) muelle::node3(f, i)[2] = band * (places[i] - muelle::node3(x, i)[2]);
    addTo(f, submission::meanHeightForce(stackedAt(x), target, stiffness));
  });
  muelle::State start;
  for (int i = 0; i < 5; ++i) {
    start.x.insert(start.x.end(), {0.8 * i, 0.0, places[i] - 0.4});
    start.v.insert(start.v.end(), {0.0, 0.0, speeds[i]});
  }
  muelle::MarchOptions options;
  options.h = 4e-3;
  options.duration = 4.0;
  options.outputEvery = 2;
  options.probes = {{"mean", "m", [](const muelle::State& at) { return submission::meanHeight(stackedAt(at.x)); }}};
  return march(system, start, options);
}

/// One coordinate of the centre of mass over time.
std::vector<double> centre(const muelle::Trajectory& run, const VecX& m, int axis) {
  std::vector<double> values(run.t.size(), 0.0);
  for (int i = 0; i < static_cast<int>(m.size()); ++i) {
    const std::vector<double> x = run.position(3 * i + axis);
    for (std::size_t at = 0; at < x.size(); ++at) values[at] += m[i] / m.sum() * x[at];
  }
  return values;
}

muelle::Figure heights() {
  const muelle::Trajectory run = jump();
  muelle::Figure figure("heights", "A class on bands, with a force on its mean height", "time [s]");
  auto each = figure.panel("height [m]");
  each.expect(0.0, 3.8);
  for (int i = 0; i < 5; ++i)
    each.line("pupil of " + std::to_string(static_cast<int>(pupils[i])) + " kg", run.t, run.position(3 * i + 2));
  figure.panel("height [m]")
      .line("mean height", run.t, run.track("mean"))
      .line("centre of mass", run.t, centre(run, pupils, 2))
      .reference("target", {run.t.front(), run.t.back()}, {target, target})
      .expect(1.4, 2.6);
  return figure;
}

// --- one pupil is raised --------------------------------------------------------------------------------------------

muelle::Figure raised() {
  constexpr double k = 90.0;  // [N/m]
  const auto with = [](double z) {
    VecX x(9);
    x << 0, 0, z, 1, 0, 1.5, 2, 0, 2.5;
    return x;
  };
  const auto energy = [&](double z) { return submission::meanHeightEnergy(with(z), target, k); };
  std::vector<double> z, stored, force, sparse, slope;
  for (int i = 0; i <= 80; ++i) {
    z.push_back(0.05 * i);
    stored.push_back(energy(z.back()));
    const VecX F = submission::meanHeightForce(with(z.back()), target, k);
    force.push_back(F.size() > 2 ? F[2] : std::nan(""));
    if (i % 5 != 0) continue;
    sparse.push_back(z.back());
    slope.push_back((energy(z.back() - 1e-3) - energy(z.back() + 1e-3)) / 2e-3);
  }
  muelle::Figure figure("raised", "One of three nodes is raised, the others stand at 1.5 m and 2.5 m",
                        "height of the node [m]");
  figure.panel("energy [J]").line("meanHeightEnergy", z, stored).expect(0, 20);
  figure.panel("force on the node along z [N]")
      .line("meanHeightForce", z, force)
      .points("minus the slope of meanHeightEnergy", sparse, slope)
      .expect(-20, 20);
  return figure;
}

// --- the spread -----------------------------------------------------------------------------------------------------

const VecX crowd = Eigen::Vector4d(0.5, 1.5, 0.8, 1.1);  // [kg]
constexpr double wide = 1.0;                             // [m], the target
constexpr double hold = 60.0;                            // [N/m]

muelle::Trajectory flyApart() {
  const muelle::FunctionSystem system(tripled(crowd), [](double, In x, In, Out f) {
    std::fill(f.begin(), f.end(), 0.0);
    addTo(f, submission::spreadForce(stackedAt(x), crowd, wide, hold));
  });
  const muelle::Probe spread{"spread", "m",
                             [](const muelle::State& at) { return submission::spread(stackedAt(at.x), crowd); }};
  const muelle::Probe stored{"stored", "J", [](const muelle::State& at) {
                               return submission::spreadEnergy(stackedAt(at.x), crowd, wide, hold);
                             }};
  const muelle::Probe kinetic = kineticEnergy(system);
  muelle::MarchOptions options;
  options.h = 2e-3;
  options.duration = 3.0;
  options.outputEvery = 4;
  options.probes = {spread, kinetic, stored, muelle::sum("total", {kinetic, stored})};
  muelle::State start;
  start.x = {-0.9, -0.4, 0.1, 0.5, -0.7, 0.0, 0.8, 0.6, -0.1, -0.4, 0.7, 0.2};
  start.v = {-0.5, -1.1, 0.1, 1.6, -0.2, 0.0, 1.1, 1.2, -0.2, 0.3, 1.0, 0.1};
  return march(system, start, options);
}

std::vector<muelle::Figure> spreading() {
  const muelle::Trajectory run = flyApart();
  muelle::Figure spread("spread", "Four nodes in empty space, with a force on their spread", "time [s]");
  spread.panel("spread [m]")
      .line("spread", run.t, run.track("spread"))
      .reference("target", {run.t.front(), run.t.back()}, {wide, wide})
      .expect(0.5, 1.5);
  spread.panel("energy [J]")
      .line("kinetic", run.t, run.track("kinetic energy"))
      .line("of the spread", run.t, run.track("stored"))
      .line("total", run.t, run.track("total"))
      .expect(0.0, 6.0);

  muelle::Figure paths("spread_paths", "Paths of the four nodes and of their centre of mass", "x [m]");
  paths.equalAxes();
  auto panel = paths.panel("y [m]");
  panel.expectX(-1.2, 3.4).expect(-1.8, 1.7);
  for (int i = 0; i < 4; ++i) panel.line("node " + std::to_string(i), run.position(3 * i), run.position(3 * i + 1));
  panel.line("centre of mass", centre(run, crowd, 0), centre(run, crowd, 1));
  return {spread, paths};
}

}  // namespace

MUELLE_DEMO {
  std::vector<muelle::Figure> figures = {heights(), raised()};
  for (const muelle::Figure& figure : spreading()) figures.push_back(figure);
  return figures;
}

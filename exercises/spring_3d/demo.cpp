#include "spring_3d.h"

#include "harness/demo.h"

// An elastic pendulum: a mass on one spring swings and bounces in the plane y = 0. The spring's energy is measured, not
// computed: it is what the spring's force has taken from the motion, minus its work along the path.

namespace {

constexpr double m = 1.0;   // [kg]
constexpr double g = 9.81;  // [m/s^2]
const std::vector<Attachment> springs = {{Vec3(0, 0, 0), 40.0, 1.0}};

Vec3 forceAt(const Vec3& x) { return m * submission::nodeAcceleration(x, m, springs, g); }

/// Work of gravity and spring together on the node since the start [J], by the trapezium rule along the path.
std::vector<double> workAlong(const std::vector<std::vector<double>>& path) {
  std::vector<double> work(path.size(), 0.0);
  Vec3 force = forceAt(muelle::node3(path[0], 0));
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3 nextForce = forceAt(muelle::node3(path[i], 0));
    const Vec3 way = muelle::node3(path[i], 0) - muelle::node3(path[i - 1], 0);
    work[i] = work[i - 1] + (force + nextForce).dot(way) / 2;
    force = nextForce;
  }
  return work;
}

}  // namespace

MUELLE_DEMO {
  const muelle::FunctionSystem system({m, m, m}, [](double, muelle::In x, muelle::In, muelle::Out f) {
    muelle::node3(f, 0) = forceAt(muelle::node3(x, 0));
  });
  muelle::MarchOptions options;
  options.h = 2e-3;
  options.duration = 5.0;
  options.outputEvery = 2;
  options.probes = {muelle::kineticEnergy(system)};
  const muelle::Trajectory run = muelle::march(system, {0.0, {0.8, 0, -1.0}, {0, 0, 0}, {}}, options);

  const std::vector<double> z = run.position(2);
  const std::vector<double>& kinetic = run.track("kinetic energy");
  const std::vector<double> work = workAlong(run.x);
  std::vector<double> height, stored, total;
  for (std::size_t i = 0; i < z.size(); ++i) {
    height.push_back(m * g * (z[i] - z[0]));
    stored.push_back(-work[i] - height[i]);  // minus the work of the spring alone
    total.push_back(kinetic[i] - work[i]);
  }

  muelle::Figure path("pendulum_path", "Path of an elastic pendulum", "x [m]");
  path.panel("z [m]")
      .line("path of your node", run.position(0), z)
      .points("start", {run.position(0).front()}, {z.front()})
      .expectX(-0.8, 0.8)
      .expect(-1.6, -0.8);
  path.equalAxes();

  muelle::Figure energy("pendulum_energy", "Energies of an elastic pendulum", "time [s]");
  energy.panel("energy since the start [J]")
      .line("kinetic", run.t, kinetic)
      .line("of height", run.t, height)
      .line("stored in the spring (minus its work)", run.t, stored)
      .line("total", run.t, total)
      .expect(-5.5, 4.5);
  return {path, energy};
}

#include "harness/demo.h"
#include "spring_1d.h"

// A node is released above its equilibrium and swings on the spring that it hangs from. Its amplitude is less than the
// length of the spring at equilibrium, so the spring never reaches L = 0.

namespace {

constexpr double m = 0.5;                     // [kg]
constexpr double g = 9.81;                    // [m/s^2]
constexpr Attachment top = {0.0, 50.0, 1.0};  // [m], [N/m], [m]
constexpr double amplitude = 0.3;             // [m]

double forceOn(double x) { return m * submission::hangingAcceleration(x, m, top, g); }

muelle::Trajectory swing(double equilibrium, double duration) {
  const muelle::FunctionSystem system({m},
                                      [](double, muelle::In x, muelle::In, muelle::Out f) { f[0] = forceOn(x[0]); });
  muelle::MarchOptions options;
  options.h = 1e-3;
  options.duration = duration;
  options.outputEvery = 2;
  options.probes = {muelle::kineticEnergy(system)};
  return muelle::march(system, {0.0, {equilibrium + amplitude}, {0.0}, {}}, options);
}

/// Work of the spring and gravity on the node since the start [J], by the trapezium rule along its path.
std::vector<double> workAlong(const std::vector<double>& x) {
  std::vector<double> work(x.size(), 0.0);
  for (std::size_t i = 1; i < x.size(); ++i) {
    work[i] = work[i - 1] + (forceOn(x[i - 1]) + forceOn(x[i])) / 2 * (x[i] - x[i - 1]);
  }
  return work;
}

}  // namespace

MUELLE_DEMO {
  const double omega = std::sqrt(top.k / m);                            // [rad/s]
  const double equilibrium = top.x - top.L0 - m * g / top.k;            // the spring carries the weight
  const double energy = m * omega * omega * amplitude * amplitude / 2;  // largest kinetic energy of the swing [J]
  const double duration = 3 * 2 * M_PI / omega;                         // three periods

  const muelle::Trajectory run = swing(equilibrium, duration);
  const std::vector<double> x = run.position(0);
  const std::vector<double>& kinetic = run.track("kinetic energy");
  const std::vector<double> work = workAlong(x);

  std::vector<double> exactX, exactKinetic, balance;
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    exactX.push_back(equilibrium + amplitude * std::cos(omega * run.t[i]));
    exactKinetic.push_back(energy * std::pow(std::sin(omega * run.t[i]), 2));
    balance.push_back(kinetic[i] - work[i]);
  }

  muelle::Figure figure("oscillator", "A node on a spring", "time [s]");
  figure.panel("height x [m]")
      .line("your node", run.t, x)
      .reference("analytic oscillator", run.t, exactX)
      .expect(equilibrium - amplitude, equilibrium + amplitude);
  figure.panel("energy [J]")
      .line("kinetic", run.t, kinetic)
      .line("kinetic minus work of the forces", run.t, balance)
      .reference("analytic kinetic", run.t, exactKinetic)
      .expect(0.0, energy);
  return {figure};
}

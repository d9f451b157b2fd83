#include "harness/demo.h"
#include "energy_gradient.h"

// Node b stays at the origin, node a is led by hand: along a line that leaves it, then round a loop that comes back.

namespace {

constexpr double k = 40.0;  // [N/m]
constexpr double L0 = 0.5;  // [m]

Vec6 withA(const Vec3& xa) {
  Vec6 x;
  x << xa, Vec3::Zero();
  return x;
}

double energy(const Vec3& xa) { return submission::springEnergy(withA(xa), k, L0); }

/// Central differences of the energy with respect to xa.
Vec3 slopes(const Vec3& xa, double h) {
  Vec3 slope;
  for (int i = 0; i < 3; ++i) slope[i] = (energy(xa + h * Vec3::Unit(i)) - energy(xa - h * Vec3::Unit(i))) / (2 * h);
  return slope;
}

muelle::Figure stretch() {
  const Vec3 along = Vec3(2, 1, 2) / 3;  // a unit vector
  std::vector<double> length, stored, force;
  for (int i = 0; i <= 110; ++i) {
    const double L = i == 0 ? 1e-9 : 0.01 * i;  // at L = 0 itself there is no direction
    length.push_back(L);
    stored.push_back(energy(L * along));
    force.push_back(along.dot(Vec3(submission::springForces(withA(L * along), k, L0).head<3>())));
  }
  std::vector<double> sparse, minusSlope;
  for (int i = 1; i <= 22; ++i) {
    const double L = 0.05 * i;
    sparse.push_back(L);
    minusSlope.push_back(-along.dot(slopes(L * along, 1e-4)));
  }
  muelle::Figure figure("stretch", "Energy and force of a spring that is stretched", "length [m]");
  const double most = 0.6;  // [m] of stretch, at the end
  figure.panel("energy [J]").line("springEnergy", length, stored).expect(0.0, k / 2 * most * most);
  figure.panel("force on a along ab [N]")
      .line("springForces", length, force)
      .points("minus the slope of springEnergy", sparse, minusSlope)
      .expect(-k * most, k * L0);
  return figure;
}

/// The rounded path of a, at a time in [0, 1] s: from the rest length out to a stretched spring, across, and back.
Vec3 onLoop(double t) {
  const double angle = 2 * M_PI * t;
  return {0.85 - 0.35 * std::cos(angle), 0.3 * std::sin(angle), 0.15 * std::sin(2 * angle)};
}

muelle::Figure cycle() {
  constexpr int steps = 400;
  std::vector<double> t, work, sparseT, stored;
  double done = 0.0;  // by the hand, against the spring
  for (int i = 0; i <= steps; ++i) {
    const double now = static_cast<double>(i) / steps;
    if (i > 0) {  // the force halfway, along the chord
      const double before = static_cast<double>(i - 1) / steps;
      const Vec3 halfway = (onLoop(before) + onLoop(now)) / 2;
      const Vec3 force = submission::springForces(withA(halfway), k, L0).head<3>();
      done -= force.dot(onLoop(now) - onLoop(before));
    }
    t.push_back(now);
    work.push_back(done);
    if (i % 16 == 0) {
      sparseT.push_back(now);
      stored.push_back(energy(onLoop(now)) - energy(onLoop(0.0)));
    }
  }
  muelle::Figure figure("cycle", "Work and energy of a cycle of stretch and release", "time [s]");
  figure.panel("energy [J]")
      .line("work against springForces", t, work)
      .points("gain of springEnergy", sparseT, stored)
      .expect(0.0, 10.0);
  return figure;
}

muelle::Figure convergence() {
  const Vec3 xa(0.5, 0.3, -0.4);
  const Vec3 gradient = submission::energyGradient(withA(xa), k, L0).head<3>();
  std::vector<double> step, error, slopeTwo;
  for (int i = 4; i <= 40; ++i) {
    const double h = std::pow(10.0, -0.25 * i);
    step.push_back(h);
    error.push_back((slopes(xa, h) - gradient).norm());
    slopeTwo.push_back(h >= 1e-5 ? 10 * h * h : std::nan(""));
  }
  muelle::Figure figure("finite_difference", "Central differences of the energy against the gradient",
                        "step of the difference [m]");
  figure.logX();
  figure.panel("distance from the gradient [N]")
      .logY()
      .points("springEnergy against energyGradient", step, error)
      .reference("order 2", step, slopeTwo);
  return figure;
}

}  // namespace

MUELLE_DEMO { return {stretch(), cycle(), convergence()}; }

#include "harness/demo.h"
#include "damping.h"

// A pair of nodes is let go: it falls, turns about its middle and vibrates, all at once. The same pair three times,
// with the same d and one of the three dampers each.

namespace {

using muelle::In;
using muelle::node3;
using muelle::Out;
using muelle::State;

constexpr double m = 1.0;           // [kg], each node
constexpr double d = 0.6;           // [N s/m]
constexpr double g = 9.81;          // [m/s^2]
constexpr double length = 1.0;      // [m], of the bond at rest
constexpr double stiffness = 20.0;  // [N/m], of the bond

/// Damping force on the first of two nodes.
using Damper = std::function<Vec3(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb)>;

/// What holds the pair together: not the spring of the exercises, but a stiff bond with a polynomial law.
Vec3 bondForce(const Vec3& difference) {
  return stiffness * (1.0 - difference.squaredNorm() / (length * length)) * difference;
}

Vec3 difference(In values) { return node3(values, 0) - node3(values, 1); }

/// Angular momentum about the centre of mass, along z, of two equal masses.
double spin(const State& state) {
  const Vec3 r = difference(state.x), v = difference(state.v);
  return m / 2 * (r.x() * v.y() - r.y() * v.x());
}

muelle::Trajectory letGo(const Damper& damper) {
  const muelle::FunctionSystem system(std::vector<double>(6, m), [&damper](double, In x, In v, Out f) {
    const Vec3 bond = bondForce(difference(x)), weight(0, 0, -m * g);
    node3(f, 0) = weight + bond + damper(node3(x, 0), node3(x, 1), node3(v, 0), node3(v, 1));
    node3(f, 1) = weight - bond + damper(node3(x, 1), node3(x, 0), node3(v, 1), node3(v, 0));
  });
  State start;
  start.x = {0.6, 0, 0, -0.6, 0, 0};
  start.v = {0, 1, 0, 0, -1, 0};
  muelle::MarchOptions options;
  options.h = 6e-3;
  options.duration = 6.0;
  options.outputEvery = 3;
  options.probes = {{"falling speed", "m/s", [](const State& s) { return -(s.v[2] + s.v[5]) / 2; }},
                    {"angular momentum", "kg m²/s", spin},
                    {"length", "m", [](const State& s) { return difference(s.x).norm(); }}};
  return march(system, start, options);
}

/// The values of f at the times of the run.
std::vector<double> at(const std::vector<double>& times, const std::function<double(double)>& f) {
  std::vector<double> values;
  for (const double t : times) values.push_back(f(t));
  return values;
}

}  // namespace

MUELLE_DEMO {
  const muelle::Trajectory node =
      letGo([](const Vec3&, const Vec3&, const Vec3& va, const Vec3&) { return submission::nodeDamping(va, d); });
  const muelle::Trajectory relative = letGo(
      [](const Vec3&, const Vec3&, const Vec3& va, const Vec3& vb) { return submission::relativeDamping(va, vb, d); });
  const muelle::Trajectory projected = letGo([](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb) {
    return submission::projectedDamping(xa, xb, va, vb, d);
  });

  muelle::Figure figure("dampers", "One pair, three dampers", "time [s]");
  const auto panel = [&](const char* label, const char* track, double low, double high) {
    auto builder = figure.panel(label);
    builder.expect(low, high);
    builder.line("node", node.t, node.track(track));
    builder.line("relative velocity", relative.t, relative.track(track));
    builder.line("projected velocity", projected.t, projected.track(track));
    return builder;
  };
  // Two of the dampers do not brake the fall.
  panel("falling speed [m/s]", "falling speed", 0.0, g * node.t.back())
      .reference("final speed m g / d", node.t, at(node.t, [](double) { return m * g / d; }));
  // Equal nodes have the reduced mass m / 2.
  const double start = 1.2 * m;
  panel("angular momentum [kg m²/s]", "angular momentum", 0.0, start)
      .reference("rate d / m", node.t, at(node.t, [=](double t) { return start * std::exp(-t * d / m); }))
      .reference("rate d / mu", node.t, at(node.t, [=](double t) { return start * std::exp(-t * d / (m / 2)); }));
  panel("length [m]", "length", 0.8, 1.2);
  return {figure};
}

#include "harness/demo.h"
#include "generalised_springs.h"

// Nothing acts but the springs of the exercise: a hinge that opens and closes, a triangle that breathes, a tetrahedron
// that starts inside out.

namespace {

using muelle::In;
using muelle::Out;

/// Unequal masses, three components a node [kg].
std::vector<double> masses(int nodes) {
  std::vector<double> m;
  for (int i = 0; i < nodes; ++i) m.insert(m.end(), 3, 0.4 + 0.2 * i);
  return m;
}

template <class Vector>
Vector at(In x) {
  return Eigen::Map<const Vector>(x.data());
}

/// A free flight from `start` under a force, with the number, the elastic and the kinetic energy measured.
template <class Vector, class Number, class Energy, class Force>
muelle::Trajectory fly(const std::vector<double>& start, double duration, const Number& number, const Energy& energy,
                       const Force& force) {
  const muelle::FunctionSystem system(masses(static_cast<int>(start.size()) / 3), [&](double, In x, In, Out f) {
    const Vector F = force(at<Vector>(x));
    std::copy(F.begin(), F.end(), f.begin());
  });
  const muelle::Probe kinetic = kineticEnergy(system);
  const muelle::Probe stored{"stored", "J", [&](const muelle::State& s) { return energy(at<Vector>(s.x)); }};
  const muelle::Probe measured{"number", "", [&](const muelle::State& s) { return number(at<Vector>(s.x)); }};
  muelle::MarchOptions options;
  options.h = duration / 2000;
  options.duration = duration;
  options.outputEvery = 8;
  options.probes = {measured, kinetic, stored, muelle::sum("total", {kinetic, stored})};
  return march(system, {0.0, start, std::vector<double>(start.size(), 0.0), {}}, options);
}

muelle::Figure drawn(const char* id, const char* title, const char* what, const muelle::Trajectory& run, double rest,
                     double low, double high, double most) {
  muelle::Figure figure(id, title, "time [s]");
  figure.panel(what)
      .line("of your nodes", run.t, run.track("number"))
      .reference("at rest", {run.t.front(), run.t.back()}, {rest, rest})
      .expect(low, high);
  figure.panel("energy [J]")
      .line("kinetic", run.t, run.track("kinetic energy"))
      .line("of the spring", run.t, run.track("stored"))
      .line("total", run.t, run.track("total"))
      .expect(0.0, most);
  return figure;
}

muelle::Figure hinge() {
  constexpr double rest = 0.9, k = 3.0;
  const auto run = fly<Vec9>(
      {-0.9, 0.3, 0.1, 0.0, 0.0, 0.0, 0.1, 0.8, 0.2}, 4.0, submission::bendingAngle,
      [](const Vec9& x) { return submission::bendingEnergy(x, rest, k); },
      [](const Vec9& x) { return submission::bendingForce(x, rest, k); });
  return drawn("hinge", "A bending spring in empty space", "angle [rad]", run, rest, 0.0, 2.0, 2.0);
}

muelle::Figure triangle() {
  constexpr double rest = 0.6, k = 30.0;
  const auto run = fly<Vec9>(
      {0.0, 0.0, 0.0, 1.3, 0.1, 0.2, 0.4, 1.2, -0.1}, 3.0, submission::triangleArea,
      [](const Vec9& x) { return submission::areaEnergy(x, rest, k); },
      [](const Vec9& x) { return submission::areaForce(x, rest, k); });
  return drawn("triangle", "An area spring in empty space", "area [m²]", run, rest, 0.0, 1.0, 1.5);
}

muelle::Figure tetrahedron() {
  constexpr double rest = 0.3, k = 60.0;
  const auto run = fly<Vec12>(
      {0.0, 0.0, 0.0, 1.2, 0.1, 0.2, 0.3, 1.1, -0.1, 0.4, 0.3, -0.5}, 2.0, submission::tetrahedronVolume,
      [](const Vec12& x) { return submission::volumeEnergy(x, rest, k); },
      [](const Vec12& x) { return submission::volumeForce(x, rest, k); });
  return drawn("tetrahedron", "A volume spring on a tetrahedron that starts inside out", "volume [m³]", run, rest, -0.3,
               1.0, 6.0);
}

}  // namespace

MUELLE_DEMO { return {hinge(), triangle(), tetrahedron()}; }

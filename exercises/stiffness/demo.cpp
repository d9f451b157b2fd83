#include "harness/demo.h"
#include "stiffness.h"

// What a step of backward Euler does with energy: two nodes that should swing for ever, in steps of three lengths. What
// it is for: a rope so stiff that explicit methods need steps below a millisecond.

namespace {

/// A motion in steps of h; ends at a state of another size than the first.
std::vector<State> march(State now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h,
                         double duration) {
  const Eigen::Index n = now.x.size();
  std::vector<State> states = {std::move(now)};
  for (int i = 1; i <= static_cast<int>(std::round(duration / h)); ++i) {
    State next = submission::backwardEulerStep(states.back(), m, springs, F, h);
    if (next.x.size() != n || next.v.size() != n) break;
    states.push_back(std::move(next));
  }
  return states;
}

/// One number of each state, and the times.
struct Curve {
  std::vector<double> t, y;
};
template <class Number>
Curve over(const std::vector<State>& states, double h, const Number& number) {
  Curve curve;
  for (std::size_t i = 0; i < states.size(); ++i) {
    curve.t.push_back(static_cast<double>(i) * h);
    curve.y.push_back(number(states[i]));
  }
  return curve;
}

std::string milliseconds(double h) { return "h = " + std::to_string(static_cast<int>(std::round(1000 * h))) + " ms"; }

// --- two nodes that swing -------------------------------------------------------------------------------------------

/// 0.5 kg each on 9.87 N/m, of which each sees half of the length: 2 pi rad/s, one swing a second.
muelle::Figure swing() {
  const double m = 0.5, k = M_PI * M_PI, duration = 4.0;
  const auto apart = [](const State& s) { return s.x[0] - s.x[3]; };
  const auto energy = [&](const State& s) {
    return 0.5 * m * s.v.squaredNorm() + 0.5 * k * (s.x.head<3>() - s.x.tail<3>()).squaredNorm();
  };
  muelle::Figure figure("swing", "Two nodes on a spring without any damper", "time [s]");
  auto position = figure.panel("distance along x [m]");
  auto stored = figure.panel("energy [J]");
  position.expect(-1.0, 1.0);
  stored.expect(0.0, 5.0);
  for (const double h : {0.1, 0.02, 0.004}) {
    const auto states =
        march({VecX{{0.5, 0, 0, -0.5, 0, 0}}, VecX::Zero(6)}, VecX{{m, m}}, {{0, 1, k, 0}}, VecX::Zero(6), h, duration);
    const Curve x = over(states, h, apart), E = over(states, h, energy);
    position.line(milliseconds(h), x.t, x.y);
    stored.line(milliseconds(h), E.t, E.y);
  }
  std::vector<double> t, exact;
  for (int i = 0; i <= 400; ++i) {
    t.push_back(duration * i / 400);
    exact.push_back(std::cos(2 * M_PI * t.back()));
  }
  position.reference("exact", t, exact);
  stored.reference("exact", {0.0, duration}, {k / 2, k / 2});
  return figure;
}

// --- a stiff rope ---------------------------------------------------------------------------------------------------

constexpr int ropeNodes = 8;
constexpr double part = 0.25, nodeMass = 0.1, g = 9.81;  // [m], [kg], [m/s^2]

std::vector<Spring> ropeSprings() {
  std::vector<Spring> springs;
  for (int i = 0; i + 1 < ropeNodes; ++i) springs.push_back({i, i + 1, 1e5, part});
  return springs;
}

/// The rope starts level and at rest. Its first node weighs a thousand tonnes and nothing pulls it down, which holds it
/// as well as a nail.
std::vector<State> rope(double h) {
  VecX m = VecX::Constant(ropeNodes, nodeMass), x = VecX::Zero(3 * ropeNodes), F = VecX::Zero(3 * ropeNodes);
  m[0] = 1e6;
  for (int i = 1; i < ropeNodes; ++i) {
    x[3 * i] = part * i;
    F[3 * i + 2] = -nodeMass * g;
  }
  return march({x, VecX::Zero(3 * ropeNodes)}, m, ropeSprings(), F, h, 3.0);
}

/// What the nodes have of height and speed; a stiff rope stores next to nothing.
double ropeEnergy(const State& s) {
  double E = 0;
  for (int i = 1; i < ropeNodes; ++i) {
    E += nodeMass * g * s.x[3 * i + 2] + 0.5 * nodeMass * s.v.segment<3>(3 * i).squaredNorm();
  }
  return E;
}

constexpr double ropeSteps[] = {0.02, 0.01, 0.005};  // [s]

std::vector<muelle::Figure> ropes() {
  muelle::Figure motion("rope", "A rope of stiff springs falls from level, held at one end", "time [s]");
  auto end = motion.panel("height of the free end [m]");
  auto stored = motion.panel("energy [J]");
  muelle::Figure path("rope_path", "Path of the free end of the rope", "x [m]");
  path.equalAxes();
  auto plane = path.panel("height [m]");
  const double length = part * (ropeNodes - 1);
  end.expect(-length, 0.0);
  stored.expect(-7.0, 0.0);
  plane.expectX(-length, length).expect(-length, 0.0);
  for (const double h : ropeSteps) {
    const std::vector<State> states = rope(h);
    const Curve x = over(states, h, [](const State& s) { return s.x[3 * ropeNodes - 3]; });
    const Curve z = over(states, h, [](const State& s) { return s.x[3 * ropeNodes - 1]; });
    const Curve E = over(states, h, ropeEnergy);
    end.line(milliseconds(h), z.t, z.y);
    stored.line(milliseconds(h), E.t, E.y);
    plane.line(milliseconds(h), x.y, z.y);
  }
  return {motion, path};
}

}  // namespace

MUELLE_DEMO {
  std::vector<muelle::Figure> figures = ropes();
  figures.insert(figures.begin(), swing());
  return figures;
}

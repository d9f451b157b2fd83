/// \file
/// The numbers that the figures of methods and damping draw, against closed forms. A curve is the one that the figure
/// gives the name to, so that a name at the wrong curve fails too.

#include "figure_list.h"
#include "harness/types.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace muelle::plots {
namespace {

using Numbers = std::vector<double>;

Figure drawn(const std::string& name) {
  for (const LectureFigure& figure : lectureFigures()) {
    if (figure.name == name) return figure.draw();
  }
  throw std::invalid_argument("no figure " + name);
}

/// The curve at which a text that begins so stands.
const Series& curveNamed(const Panel& panel, const std::string& beginning) {
  for (const Note& note : panel.notes) {
    if (note.curve >= 0 && note.text.starts_with(beginning)) return panel.series[static_cast<std::size_t>(note.curve)];
  }
  throw std::invalid_argument("no curve " + beginning);
}

bool says(const Panel& panel, const std::string& text) {
  return std::ranges::any_of(panel.notes, [&](const Note& note) { return note.text == text; });
}

// ---- oscillator_by_method

constexpr double hOmega = 0.3;

TEST(OscillatorByMethod, EulerMethodsSpiralAsTheirEigenvaluesSay) {
  const Panel panel = drawn("oscillator_by_method").panels()[0];
  const Series &out = curveNamed(panel, "explicit Euler"), &in = curveNamed(panel, "backward Euler");
  // 1 + i hOmega multiplies the orbit by sqrt(1 + hOmega^2) a step, 1 / (1 - i hOmega) divides it by that.
  ASSERT_GT(out.x.size(), 20U);
  ASSERT_EQ(in.x.size(), 43U);
  // Round-off: fifty steps of a few 1e-16; backward Euler's equation is solved to its tolerance.
  for (std::size_t n = 0; n < out.x.size(); ++n) {
    const double radius = std::pow(1.0 + hOmega * hOmega, 0.5 * static_cast<double>(n));
    EXPECT_NEAR(std::hypot(out.x[n], out.y[n]) / radius, 1.0, 1e-13) << n;
  }
  for (std::size_t n = 0; n < in.x.size(); ++n) {
    const double radius = std::pow(1.0 + hOmega * hOmega, -0.5 * static_cast<double>(n));
    EXPECT_NEAR(std::hypot(in.x[n], in.y[n]) / radius, 1.0, 1e-8) << n;
  }
}

TEST(OscillatorByMethod, SaysWhereTheSpiralLeavesThePicture) {
  const Panel panel = drawn("oscillator_by_method").panels()[0];
  const Series& out = curveNamed(panel, "explicit Euler");
  // x + i v after n steps is (1 - i hOmega)^n: the first n at which either part is beyond 3.
  std::complex<double> state = 1.0;
  std::size_t n = 0;
  for (; std::max(std::abs(state.real()), std::abs(state.imag())) <= 3.0; ++n) state *= std::complex(1.0, -hOmega);
  EXPECT_EQ(out.x.size(), n + 1);
  EXPECT_TRUE(says(panel, fmt::format("leaves the picture at ωt = {:.1f}", hOmega * static_cast<double>(n))));
  EXPECT_EQ(panel.yRange, FixedRange(std::pair(-3.0, 3.0)));
}

TEST(OscillatorByMethod, SymplecticMethodsKeepTheirEllipse) {
  const Panel panel = drawn("oscillator_by_method").panels()[1];
  const Series &euler = curveNamed(panel, "symplectic Euler"), &verlet = curveNamed(panel, "velocity Verlet");
  constexpr int firstStep = 2053;  // 98 * 2 pi / 0.3 = 2052.5
  ASSERT_EQ(euler.x.size(), 42U);
  ASSERT_EQ(verlet.x.size(), 42U);
  // Both step by x[n+1] = (2 - hOmega^2) x[n] - x[n-1]: a turn by theta with cos(theta) = 1 - hOmega^2 / 2.
  const double theta = std::acos(1.0 - 0.5 * hOmega * hOmega);
  // Rounding adds up over 2000 steps of 1e-16 each, in the phase faster than in the energy.
  constexpr double tolerance = 1e-11;
  for (std::size_t i = 0; i < euler.x.size(); ++i) {
    const double n = firstStep + static_cast<double>(i);
    const double slope = (1.0 - hOmega * hOmega - std::cos(theta)) / std::sin(theta);  // from x[1] = 1 - hOmega^2
    EXPECT_NEAR(euler.x[i], std::cos(n * theta) + slope * std::sin(n * theta), tolerance);
    EXPECT_NEAR(euler.x[i] * euler.x[i] - hOmega * euler.x[i] * euler.y[i] + euler.y[i] * euler.y[i], 1.0, tolerance);
    const double shape = 1.0 - 0.25 * hOmega * hOmega;
    EXPECT_NEAR(verlet.x[i], std::cos(n * theta), tolerance);
    EXPECT_NEAR(shape * verlet.x[i] * verlet.x[i] + verlet.y[i] * verlet.y[i], shape, tolerance);
  }
}

// ---- order_of_convergence

/// log2 of the ratio of neighbouring errors, at the smallest steps whose errors are all above `floor`.
double slopeOf(const Series& series, double floor) {
  std::size_t last = 0;
  while (last + 1 < series.y.size() && series.y[last + 1] > floor) ++last;
  EXPECT_GT(last, 0U);
  return std::log2(series.y[last - 1] / series.y[last]);
}

TEST(OrderOfConvergence, EachCurveFallsByTwoToTheOrderDownToRoundOff) {
  const Panel panel = drawn("order_of_convergence").panels()[0];
  struct Method {
    std::string name;
    double order, tolerance;
  };
  // The next term of the error is about h omega times the last (omega = 11 /s of the spring): 2e-4 of it at the
  // smallest step of the lowest orders. Where the errors end above round-off, h omega is 0.005 (order 4) and 0.3 (order
  // 8).
  const std::vector<Method> methods = {{"symplectic Euler", 1, 0.01},
                                       {"velocity Verlet", 2, 0.01},
                                       {"classical Runge-Kutta", 4, 0.05},
                                       {"Kahan-Li", 8, 0.2}};
  for (const auto& [name, order, tolerance] : methods) {
    const Series& errors = curveNamed(panel, name);
    for (std::size_t i = 1; i < errors.x.size(); ++i) EXPECT_DOUBLE_EQ(errors.x[i - 1], 2.0 * errors.x[i]);
    EXPECT_NEAR(slopeOf(errors, 1e-12), order, tolerance) << name;
  }
  // Positions of 1 m carry 1e-16 m; n steps of rounding leave at most n times that.
  for (const std::string name : {"classical Runge-Kutta", "Kahan-Li"}) {
    const Series& errors = curveNamed(panel, name);
    EXPECT_LT(*std::ranges::min_element(errors.y), 1e-12) << name;
    EXPECT_LT(errors.y.back(), 1e-12) << name;
    const double halvings = std::log2(errors.y[errors.y.size() - 3] / errors.y.back());
    EXPECT_LT(std::abs(halvings), 4.0) << name << ": two halvings would divide by 2^8 or 2^16 above the floor";
  }
  for (const double error : curveNamed(panel, "symplectic Euler").y) EXPECT_GT(error, 1e-6);
}

struct Motion {
  Vec3 x{0.8175, 0.0, -0.613125}, v{0.0, 3.27, 0.0};
};

Vec3 pendulumAcceleration(const Vec3& x) {
  const double length = x.norm();
  return Vec3(0.0, 0.0, -9.81) - 100.0 * (length - 0.858375) / length * x;
}

// The methods' formulas, written out here.
void symplecticEulerStep(Motion& m, double h) {
  m.v += h * pendulumAcceleration(m.x);
  m.x += h * m.v;
}

void verletStep(Motion& m, double h) {
  const Vec3 a = pendulumAcceleration(m.x);
  m.x += h * m.v + 0.5 * h * h * a;
  m.v += 0.5 * h * (a + pendulumAcceleration(m.x));
}

void rungeKuttaStep(Motion& m, double h) {
  const Vec3 v1 = m.v, a1 = pendulumAcceleration(m.x);
  const Vec3 v2 = m.v + 0.5 * h * a1, a2 = pendulumAcceleration(m.x + 0.5 * h * v1);
  const Vec3 v3 = m.v + 0.5 * h * a2, a3 = pendulumAcceleration(m.x + 0.5 * h * v2);
  const Vec3 v4 = m.v + h * a3, a4 = pendulumAcceleration(m.x + h * v3);
  m.x += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
  m.v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
}

/// The error that so many steps leave on the conical pendulum after 2 s.
double pendulumError(void (*step)(Motion&, double), int steps) {
  Motion m;
  for (int i = 0; i < steps; ++i) step(m, 2.0 / steps);
  return (m.x - Vec3(0.8175 * std::cos(8.0), 0.8175 * std::sin(8.0), -0.613125)).norm();
}

TEST(OrderOfConvergence, ErrorsAreThoseOfTheFormulasAndTrianglesSayTheirSlope) {
  const Panel panel = drawn("order_of_convergence").panels()[0];
  const std::pair<std::string, void (*)(Motion&, double)> methods[] = {{"symplectic Euler", symplecticEulerStep},
                                                                       {"velocity Verlet", verletStep},
                                                                       {"classical Runge-Kutta", rungeKuttaStep}};
  for (const auto& [name, step] : methods) {
    const Series& errors = curveNamed(panel, name);
    ASSERT_GT(errors.x.size(), 10U);
    for (std::size_t i = 0; i < errors.x.size(); ++i) {
      const int steps = static_cast<int>(std::lround(2.0 / errors.x[i]));
      if (steps > 1024) break;
      // A thousand steps round by at most 1e-13 m.
      const double expected = pendulumError(step, steps);
      EXPECT_NEAR(errors.y[i], expected, 1e-6 * expected + 1e-13) << name << ", " << steps;
    }
  }
  Numbers powers;
  for (const Series& series : panel.series) {
    if (series.pen != Pen::Structure) continue;
    powers.push_back(std::log(series.y[2] / series.y[1]) / std::log(series.x[1] / series.x[0]));
  }
  ASSERT_EQ(powers.size(), 4U);
  const double expected[] = {1, 2, 4, 8};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(powers[i], expected[i], 1e-12);
    EXPECT_TRUE(says(panel, fmt::format("p = {}", expected[i])));
  }
}

// ---- stability_limit

TEST(StabilityLimit, GrowthIsTheStabilityFunctions) {
  const Panel panel = drawn("stability_limit").panels()[0];
  const Series& explicitEuler = curveNamed(panel, "explicit Euler");
  const Series& verlet = curveNamed(panel, "velocity Verlet");
  const Series& symplecticEuler = curveNamed(panel, "symplectic Euler");
  const Series& rungeKutta = curveNamed(panel, "classical Runge-Kutta");
  ASSERT_GT(verlet.x.size(), 100U);
  for (std::size_t i = 0; i < verlet.x.size(); ++i) {
    const double y = verlet.x[i], y2 = y * y;
    const double twice = y > 2.0 ? 0.5 * (y2 - 2.0 + y * std::sqrt(y2 - 4.0)) : 1.0;
    // Rounding, of which a root takes the square root near y = 2.
    EXPECT_NEAR(explicitEuler.y[i], std::sqrt(1.0 + y2), 1e-12) << y;
    EXPECT_NEAR(verlet.y[i], twice, 1e-6) << y;
    EXPECT_NEAR(symplecticEuler.y[i], twice, 1e-6) << y;
    EXPECT_NEAR(rungeKutta.y[i], std::sqrt(1.0 - std::pow(y, 6) / 72.0 + std::pow(y, 8) / 576.0), 1e-12) << y;
  }
  // Up to where the picture is cut, which its label says.
  EXPECT_EQ(panel.yRange, FixedRange(std::pair(0.0, 3.0)));
  EXPECT_EQ(panel.yLabel, "growth per step (cut at 3)");
}

TEST(StabilityLimit, MarksEachLimitWhereItIs) {
  const Panel panel = drawn("stability_limit").panels()[0];
  const std::pair<std::string, double> limits[] = {
      {"limit 0", 0.0}, {"limit 2", 2.0}, {"limit 2√2", 2.0 * std::numbers::sqrt2}};
  for (const auto& [name, limit] : limits) {
    const auto note = std::ranges::find(panel.notes, name, &Note::text);
    ASSERT_NE(note, panel.notes.end());
    const Series& mark = panel.series[static_cast<std::size_t>(note->curve)];
    ASSERT_EQ(mark.x.size(), 1U);
    EXPECT_NEAR(mark.x[0], limit, 1e-4) << name;  // growth below 1e-11 counts as rounding: (y - limit)^(1 .. 2)
    EXPECT_EQ(mark.y[0], 1.0);
    EXPECT_NEAR(note->x, limit, 0.1);
  }
}

/// The free end [mm] of ten equal masses in a row, struck with 0.1 m/s, after each of velocity Verlet's steps: a sum
/// over the chain's modes, each by x[n+1] = (2 - (h omega)^2) x[n] - x[n-1].
Numbers struckEnd(double h, std::size_t outputs) {
  constexpr int nodes = 10;
  Numbers end(outputs, 0.0);
  for (int j = 1; j <= nodes; ++j) {
    const double angle = (2 * j - 1) * std::numbers::pi / (2 * nodes + 1);
    const double omega = 2.0 * std::sqrt(1000.0 / 0.1) * std::sin(0.5 * angle);
    const double shape = std::sin(nodes * angle);
    const double part = shape * shape / (0.25 * (2 * nodes + 1));
    double before = 0.0, now = 0.1 * h * part;
    for (std::size_t n = 1; n < outputs; ++n) {
      end[n] += 1e3 * now;
      const double next = (2.0 - h * h * omega * omega) * now - before;
      before = now;
      now = next;
    }
  }
  return end;
}

/// Of the chain: 2 / omega_max.
double chainLimit() { return 2.0 / (200.0 * std::sin(19.0 * std::numbers::pi / 42.0)); }

TEST(StabilityLimit, ChainMovesAsItsModesDo) {
  const Panel panel = drawn("stability_limit").panels()[1];
  EXPECT_EQ(panel.heading, fmt::format("velocity Verlet on a chain: limit 2/ωₘₐₓ = {:.1f} ms", 1e3 * chainLimit()));
  for (const double part : {0.99, 1.01}) {
    const Series& end = curveNamed(panel, fmt::format("h = {} × limit", part));
    ASSERT_GT(end.y.size(), 20U);
    // The engine finds a limit by bisection, to 1e-7 of it.
    EXPECT_NEAR(end.x[1] / (part * chainLimit()), 1.0, 1e-7);
    const Numbers exact = struckEnd(end.x[1], end.y.size() - 1);  // the last step ends with the run
    std::size_t seen = 0;
    for (std::size_t n = 0; n < exact.size() && std::isfinite(end.y[n]); ++n, ++seen) {
      EXPECT_NEAR(end.y[n], exact[n], 1e-8)
          << part << ", step " << n;  // mm: rounding of 1 m, grown at most a hundredfold
    }
    if (part < 1.0) {
      EXPECT_EQ(seen, exact.size());
    } else {
      // Shown until it is beyond three times the right answer, and not when it comes back.
      EXPECT_GT(std::abs(end.y[seen - 1]), 3.0);
      EXPECT_LE(std::abs(end.y[seen - 2]), 3.0);
      EXPECT_TRUE(says(panel, fmt::format("leaves the picture at t = {:.2f} s", end.x[seen - 1])));
      EXPECT_TRUE(std::all_of(end.y.begin() + static_cast<std::ptrdiff_t>(seen), end.y.end(),
                              [](double y) { return std::isnan(y); }));
    }
  }
}

// ---- stability_regions

/// |1 + s + s^2/2 + s^3/6 + s^4/24| at y times the larger eigenvalue of x'' = -x - 2 zeta x'.
double rungeKuttaGrowth(double zeta, double y) {
  const std::complex<double> root = std::sqrt(std::complex(zeta * zeta - 1.0, 0.0));
  double growth = 0.0;
  for (const std::complex<double> s : {y * (-zeta + root), y * (-zeta - root)}) {
    growth = std::max(growth, std::abs(1.0 + s * (1.0 + s / 2.0 * (1.0 + s / 3.0 * (1.0 + s / 4.0)))));
  }
  return growth;
}

/// A limit is the first step that grows: none below does, the next does. `slack` covers a growth that counts as none,
/// 1e-9, which weak growth reaches late, and rounding of double eigenvalues.
void expectFirstGrowth(double (*growth)(double, double), const Series& limits) {
  constexpr double slack = 1e-3;
  for (std::size_t i = 0; i < limits.x.size(); ++i) {
    const double zeta = limits.x[i], limit = limits.y[i];
    ASSERT_TRUE(std::isfinite(limit));
    for (double y = 0.05; y < limit - slack; y += 0.05) EXPECT_LE(growth(zeta, y), 1.0 + 1e-7) << zeta << ", " << y;
    EXPECT_LE(growth(zeta, limit - slack), 1.0 + 1e-7) << zeta;
    EXPECT_GT(growth(zeta, limit + slack), 1.0) << zeta;
  }
}

TEST(StabilityRegions, EulerMethodsFollowTheirClosedForms) {
  const Panel panel = drawn("stability_regions").panels()[0];
  const Series &forward = curveNamed(panel, "explicit Euler"), &symplectic = curveNamed(panel, "symplectic Euler");
  ASSERT_GT(forward.x.size(), 100U);
  for (std::size_t i = 0; i < forward.x.size(); ++i) {
    const double zeta = forward.x[i];
    // |1 - y (zeta ± i sqrt(1 - zeta^2))| = 1; beyond zeta = 1 the faster of the two decays alone decides.
    const double limit = zeta <= 1.0 ? 2.0 * zeta : 2.0 / (zeta + std::sqrt(zeta * zeta - 1.0));
    // A growth of 1e-9 counts as none: y^2 / 2 without damping, so up to y = 4.5e-5.
    EXPECT_NEAR(forward.y[i], limit, 1e-4) << zeta;
    EXPECT_NEAR(symplectic.y[i], 2.0 * (std::sqrt(1.0 + zeta * zeta) - zeta), 1e-4) << zeta;
  }
}

TEST(StabilityRegions, VerletAndRungeKuttaStopWhereTheyBeginToGrow) {
  const Panel panel = drawn("stability_regions").panels()[0];
  expectFirstGrowth(rungeKuttaGrowth, curveNamed(panel, "classical Runge-Kutta"));
  const Series& verlet = curveNamed(panel, "velocity Verlet");
  for (std::size_t i = 0; i < verlet.x.size(); ++i) {
    // x+ = x + y v + y^2/2 a, v+ = v + y/2 (a + a+), a+ = -x+ - 2 zeta (v + y a): all three change their sign where
    // y^2 + 8 zeta y = 4.
    const double zeta = verlet.x[i];
    EXPECT_NEAR(verlet.y[i], 2.0 * (std::sqrt(1.0 + 4.0 * zeta * zeta) - 2.0 * zeta), 1e-4) << zeta;
  }
}

TEST(StabilityRegions, BackwardEulerHasNoLimit) {
  const Panel panel = drawn("stability_regions").panels()[0];
  EXPECT_TRUE(says(panel, "backward Euler: no limit"));
  ASSERT_EQ(panel.series.size(), 5U);
  for (const double limit : panel.series.back().y) EXPECT_TRUE(std::isnan(limit));
}

// ---- damping_rotating_pair

TEST(DampingRotatingPair, LosesWhatTheDampingTakes) {
  const Figure figure = drawn("damping_rotating_pair");
  const Panel &turning = figure.panels()[0], &drifting = figure.panels()[1];
  constexpr double rate = 0.3 / 1.5;  // d / m [1/s]
  // Node damping: every velocity decays by d / m. Relative: the torque on the pair is -d r x (va - vb), so that the
  // angular momentum of the reduced mass m / 2 decays by 2 d / m. Projected: no torque. Runge-Kutta with h omega = 0.02
  // leaves (h omega)^4 / 120 of an elastic oscillation that itself is a few per cent.
  constexpr double tolerance = 1e-6;  // %
  const auto expectDecay = [&](const Series& curve, double decay) {
    ASSERT_EQ(curve.x.size(), 501U);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      EXPECT_NEAR(curve.y[i], 100.0 * std::exp(-decay * curve.x[i]), tolerance) << curve.x[i];
    }
  };
  expectDecay(curveNamed(turning, "at the nodes: exp(−dt/m)"), rate);
  expectDecay(curveNamed(turning, "relative: exp(−2dt/m)"), 2.0 * rate);
  expectDecay(curveNamed(turning, "projected"), 0.0);
  expectDecay(curveNamed(drifting, "at the nodes: exp(−dt/m)"), rate);
  ASSERT_EQ(drifting.series.size(), 3U);
  expectDecay(drifting.series[1], 0.0);
  expectDecay(drifting.series[2], 0.0);
}

}  // namespace
}  // namespace muelle::plots

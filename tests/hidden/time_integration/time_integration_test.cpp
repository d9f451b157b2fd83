#include "time_integration.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "course/testing/test_function.h"
#include "engine/integrators/catalogue.h"
#include "grader/testing/of_use.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <functional>
#include <limits>

using muelle::BadQuestion;
using muelle::In;
using muelle::Out;
using muelle::Random;
using muelle::TestFunction;
using muelle::testRandom;

namespace {

using Asked = TestFunction<VecX(double, const VecX&, const VecX&)>;
using AskedPosition = TestFunction<VecX(double, const VecX&)>;

/// A tolerance for values: some 60 roundings of 1.1e-16, each made ten times as large by a force that is steep, are
/// 7e-14 of the numbers involved; single precision is off by 6e-8.
double inRounding(double scale) { return 1e-12 * scale; }

/// A tolerance for laws, which are about structure and not about digits: single precision breaks none of them.
double inStructure(double scale) { return 1e-5 * scale; }

// --- forces ---------------------------------------------------------------------------------------------------------

void expectSize(const VecX& asked, Eigen::Index n, const char* what) {
  if (asked.size() == n) return;
  throw BadQuestion(fmt::format("asks for the force with {} {}, where there are {}", asked.size(), what, n));
}

/// a cos(q t) - k x^3 - d v^3 + c x' v, with x' the coordinates in reverse order: it depends on everything, no two
/// coordinates feel the same, and nothing about it is linear.
struct Nonlinear {
  double a, q, k, d, c;

  Asked of(Eigen::Index n) const {
    const std::string source = fmt::format(
        "[](double t, const VecX& x, const VecX& v) {{ return VecX({} * std::cos({} * t) - {} * x.array().cube() - "
        "{} * v.array().cube() + {} * x.array().reverse() * v.array()); }}",
        a, q, k, d, c);
    return {source, [n, F = *this](double t, const VecX& x, const VecX& v) {
              expectSize(x, n, "positions");
              expectSize(v, n, "velocities");
              return VecX(F.a * std::cos(F.q * t) - F.k * x.array().cube() - F.d * v.array().cube() +
                          F.c * x.array().reverse() * v.array());
            }};
  }

  /// The same without velocities: a cos(q t) - k x^3 + c x' x.
  AskedPosition withoutVelocity(Eigen::Index n) const {
    const std::string source = fmt::format(
        "[](double t, const VecX& x) {{ return VecX({} * std::cos({} * t) - {} * x.array().cube() + "
        "{} * x.array().reverse() * x.array()); }}",
        a, q, k, c);
    return {source, [n, F = *this](double t, const VecX& x) {
              expectSize(x, n, "positions");
              return VecX(F.a * std::cos(F.q * t) - F.k * x.array().cube() + F.c * x.array().reverse() * x.array());
            }};
  }
};

/// Two digits each, so that the force can be read.
Nonlinear someForce(Random& random) {
  const auto some = [&](double low, double high) { return std::round(10 * random.number(low, high)) / 10; };
  return {some(1.1, 2.9), some(1.2, 2.3), some(0.6, 1.4), some(0.1, 0.4), some(0.3, 0.8)};
}

/// - k x - d v
Asked dampedSpring(double k, double d) {
  const std::string source =
      fmt::format("[](double, const VecX& x, const VecX& v) {{ return VecX(-{} * x - {} * v); }}", k, d);
  return {source, [k, d](double, const VecX& x, const VecX& v) {
            expectSize(x, 1, "positions");
            expectSize(v, 1, "velocities");
            return VecX(-k * x - d * v);
          }};
}

AskedPosition spring(double k) {
  return {fmt::format("[](double, const VecX& x) {{ return VecX(-{} * x); }}", k), [k](double, const VecX& x) {
            expectSize(x, 1, "positions");
            return VecX(-k * x);
          }};
}

// --- steps ----------------------------------------------------------------------------------------------------------

/// A step to be made.
struct Case {
  Nonlinear force;
  VecX m;
  State now;
  double h;

  Eigen::Index n() const { return m.size(); }
};

/// Numbers of three digits, none of them 0 or 1, either sign.
double someNumber(Random& random) {
  const double size = random.rounded(0.22, 1.47);
  return random.integer(0, 1) == 0 ? size : -size;
}

State someState(Random& random, Eigen::Index n) {
  State state{random.rounded(0.13, 2.9), VecX(n), VecX(n)};
  for (Eigen::Index i = 0; i < n; ++i) state.x[i] = someNumber(random);
  for (Eigen::Index i = 0; i < n; ++i) state.v[i] = someNumber(random);
  return state;
}

VecX someMasses(Random& random, Eigen::Index n) {
  VecX m(n);
  for (Eigen::Index i = 0; i < n; ++i) m[i] = random.rounded(i % 2 == 0 ? 0.62 : 1.3, i % 2 == 0 ? 0.93 : 2.8);
  return m;
}

Case someCase(Random& random, Eigen::Index n) {
  return {someForce(random), someMasses(random, n), someState(random, n), random.rounded(0.12, 0.41)};
}

std::vector<Case> someCases(Random& random) {
  std::vector<Case> cases;
  for (const Eigen::Index n : {1, 2, 3, 1, 4, 2, 7, 2}) cases.push_back(someCase(random, n));
  return cases;
}

/// The ends of what the contract allows: no step and a long one, the lightest and the heaviest masses, late times, many
/// coordinates. Forces are such that everything stays in bounds.
std::vector<Case> casesOfTheWholeRange(Random& random) {
  const Nonlinear soft{1.3, 0.7, 0.0, 0.0, 0.0};  // bounded, for long steps
  std::vector<Case> cases;
  Case still = someCase(random, 2);
  still.h = 0;
  cases.push_back(still);
  Case far = someCase(random, 3);
  far.force = soft;
  far.h = 10;
  cases.push_back(far);
  Case tiny = someCase(random, 2);
  tiny.h = 1e-6;
  cases.push_back(tiny);
  Case light = someCase(random, 3);
  light.m = VecX{{1e-6, 3.7e-6, 0.41}};
  light.h = 3e-4;
  cases.push_back(light);
  Case heavy = someCase(random, 2);
  heavy.m = VecX{{0.3e6, 1e6}};
  cases.push_back(heavy);
  Case late = someCase(random, 1);
  late.now.t = 1000;
  cases.push_back(late);
  Case early = someCase(random, 1);
  early.now.t = 0;
  cases.push_back(early);
  cases.push_back(someCase(random, 30));
  return cases;
}

double sizeOf(const VecX& numbers) { return numbers.size() == 0 ? 0.0 : numbers.cwiseAbs().maxCoeff(); }

/// What rounding may be a part of: positions and velocities, and what the step adds to them.
double scaleOf(const Case& c, const State& end) {
  return std::max({sizeOf(c.now.x), sizeOf(c.now.v), sizeOf(end.x), sizeOf(end.v), c.h * sizeOf(c.now.v)});
}

void expectState(const State& got, const State& expected, double scale) {
  {
    MUELLE_LABEL("time at the end of the step", "s");
    EXPECT_NUMBER_NEAR(got.t, expected.t, inRounding(std::max(1.0, expected.t)));
  }
  {
    MUELLE_LABEL("positions at the end of the step", "m");
    EXPECT_VECTOR_NEAR(got.x, expected.x, inRounding(scale));
  }
  MUELLE_LABEL("velocities at the end of the step", "m/s");
  EXPECT_VECTOR_NEAR(got.v, expected.v, inRounding(scale));
}

/// One of the methods for forces of any kind.
using Step = std::function<State(const Force& force, const VecX& m, const State& now, double h)>;

void expectStep(const Step& submitted, const Step& right, const Case& c) {
  const Asked force = c.force.of(c.n());
  const State expected = right(force, c.m, c.now, c.h);
  expectState(submitted(force, c.m, c.now, c.h), expected, scaleOf(c, expected));
}

void expectVerletStep(const Case& c) {
  const AskedPosition force = c.force.withoutVelocity(c.n());
  const State expected = oracle::verletStep(force, c.m, c.now, c.h);
  expectState(submission::verletStep(force, c.m, c.now, c.h), expected, scaleOf(c, expected));
}

// --- the engine as a second oracle ----------------------------------------------------------------------------------

/// A case for the methods of the engine.
class EngineSystem : public muelle::engine::DynamicalSystem {
 public:
  EngineSystem(const Case& c, bool usesVelocity)
      : mass_(c.m.begin(), c.m.end()),
        usesVelocity_(usesVelocity),
        force_(c.force.of(c.n())),
        positionForce_(c.force.withoutVelocity(c.n())) {}

  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return mass_; }
  bool forceUsesVelocity() const override { return usesVelocity_; }
  void force(double t, In x, In v, In, Out f) const override {
    const VecX F = usesVelocity_ ? force_(t, vectorOf(x), vectorOf(v)) : positionForce_(t, vectorOf(x));
    std::copy(F.begin(), F.end(), f.begin());
  }

 private:
  static VecX vectorOf(In numbers) {
    return Eigen::Map<const VecX>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  }

  std::vector<double> mass_;
  bool usesVelocity_;
  Asked force_;
  AskedPosition positionForce_;
};

State engineStep(const char* method, const Case& c, bool usesVelocity) {
  const EngineSystem system(c, usesVelocity);
  muelle::State from{c.now.t, {c.now.x.begin(), c.now.x.end()}, {c.now.v.begin(), c.now.v.end()}, {}};
  muelle::State to = from;
  const auto integrator = muelle::engine::makeMethod(method);
  integrator->prepare(system, {});
  integrator->step(system, from, c.h, to);
  return {to.t, Eigen::Map<const VecX>(to.x.data(), c.n()), Eigen::Map<const VecX>(to.v.data(), c.n())};
}

void expectEngines(const Step& submitted, const char* method) {
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    const Case c = someCase(random, 3);
    const State expected = engineStep(method, c, true);
    expectState(submitted(c.force.of(c.n()), c.m, c.now, c.h), expected, scaleOf(c, expected));
  }
}

}  // namespace

// --- ExplicitEuler --------------------------------------------------------------------------------------------------

TEST(ExplicitEuler, GoesOnAsAtTheBeginning) {
  MUELLE_PROPERTY("x goes on with v, and v with F / m, both as they are at the beginning of the step");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectStep(submission::explicitEulerStep, oracle::explicitEulerStep, c);
}

TEST(ExplicitEuler, HoldsForEveryStepAndMass) {
  MUELLE_PROPERTY(
      "the step is right for any h from 0 on, for the lightest and the heaviest masses, and for 30 coordinates");
  Random random = testRandom();
  for (const Case& c : casesOfTheWholeRange(random)) {
    expectStep(submission::explicitEulerStep, oracle::explicitEulerStep, c);
  }
}

TEST(ExplicitEuler, AgreesWithTheSimulator) {
  MUELLE_PROPERTY("the step is that of the course's own simulator");
  expectEngines(submission::explicitEulerStep, "explicit_euler");
}

// --- Midpoint -------------------------------------------------------------------------------------------------------

TEST(Midpoint, GoesOnAsAtTheMiddle) {
  MUELLE_PROPERTY(
      "x goes on with the velocity of the middle, and v with the acceleration of the middle, from the beginning");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectStep(submission::midpointStep, oracle::midpointStep, c);
}

TEST(Midpoint, HoldsForEveryStepAndMass) {
  MUELLE_PROPERTY(
      "the step is right for any h from 0 on, for the lightest and the heaviest masses, and for 30 coordinates");
  Random random = testRandom();
  for (const Case& c : casesOfTheWholeRange(random)) {
    expectStep(submission::midpointStep, oracle::midpointStep, c);
  }
}

// --- Verlet ---------------------------------------------------------------------------------------------------------

TEST(Verlet, FollowsAParabolaAndTheMeanOfBothEnds) {
  MUELLE_PROPERTY("x goes by h v + h^2/2 a, and v by h times the mean of the accelerations at both ends");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectVerletStep(c);
}

TEST(Verlet, HoldsForEveryStepAndMass) {
  MUELLE_PROPERTY(
      "the step is right for any h from 0 on, for the lightest and the heaviest masses, and for 30 coordinates");
  Random random = testRandom();
  for (const Case& c : casesOfTheWholeRange(random)) expectVerletStep(c);
}

TEST(Verlet, AgreesWithTheSimulator) {
  MUELLE_PROPERTY("the step is that of the course's own simulator");
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    const Case c = someCase(random, 3);
    const State expected = engineStep("velocity_verlet", c, false);
    expectState(submission::verletStep(c.force.withoutVelocity(c.n()), c.m, c.now, c.h), expected,
                scaleOf(c, expected));
  }
}

// --- RungeKutta -----------------------------------------------------------------------------------------------------

TEST(RungeKutta, TakesTheWeightedMeanOfFour) {
  MUELLE_PROPERTY(
      "x and v go on with the mean of four slopes, each found where the one before leads, weighted 1, 2, 2, 1");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectStep(submission::rungeKuttaStep, oracle::rungeKuttaStep, c);
}

TEST(RungeKutta, HoldsForEveryStepAndMass) {
  MUELLE_PROPERTY(
      "the step is right for any h from 0 on, for the lightest and the heaviest masses, and for 30 coordinates");
  Random random = testRandom();
  for (const Case& c : casesOfTheWholeRange(random)) {
    expectStep(submission::rungeKuttaStep, oracle::rungeKuttaStep, c);
  }
}

TEST(RungeKutta, AgreesWithTheSimulator) {
  MUELLE_PROPERTY("the step is that of the course's own simulator");
  expectEngines(submission::rungeKuttaStep, "runge_kutta_4");
}

// --- Evaluations ----------------------------------------------------------------------------------------------------

namespace {

/// How often each of some steps asks for the force, whatever it makes of the answers.
void expectQuestions(const Step& submitted, const char* function, int expected) {
  Random random = testRandom();
  for (const Eigen::Index n : {1, 3}) {
    const Case c = someCase(random, n);
    const Asked force = c.force.of(n);
    submitted(force, c.m, c.now, c.h);
    MUELLE_LABEL(fmt::format("how often {} asks for the force, with {} coordinate{}", function, n, n == 1 ? "" : "s"));
    EXPECT_NUMBER_NEAR(static_cast<double>(force.calls()), expected, 0);
  }
}

}  // namespace

TEST(Evaluations, OfExplicitEulerIsOne) {
  MUELLE_PROPERTY("a step of explicit Euler asks for the force once, whatever the number of coordinates");
  MUELLE_EXPECT_ANSWERS(explicitEulerStep);
  expectQuestions(submission::explicitEulerStep, "explicitEulerStep", 1);
}

TEST(Evaluations, OfMidpointAreTwo) {
  MUELLE_PROPERTY("a step of the midpoint method asks for the force twice, whatever the number of coordinates");
  MUELLE_EXPECT_ANSWERS(midpointStep);
  expectQuestions(submission::midpointStep, "midpointStep", 2);
}

TEST(Evaluations, OfVerletAreTwo) {
  MUELLE_PROPERTY("a step of velocity Verlet asks for the force twice, whatever the number of coordinates");
  MUELLE_EXPECT_ANSWERS(verletStep);
  Random random = testRandom();
  for (const Eigen::Index n : {1, 3}) {
    const Case c = someCase(random, n);
    const AskedPosition force = c.force.withoutVelocity(n);
    submission::verletStep(force, c.m, c.now, c.h);
    MUELLE_LABEL(fmt::format("how often verletStep asks for the force, with {} coordinate{}", n, n == 1 ? "" : "s"));
    EXPECT_NUMBER_NEAR(static_cast<double>(force.calls()), 2, 0);
  }
}

TEST(Evaluations, OfRungeKuttaAreFour) {
  MUELLE_PROPERTY("a step of Runge-Kutta asks for the force four times, whatever the number of coordinates");
  MUELLE_EXPECT_ANSWERS(rungeKuttaStep);
  expectQuestions(submission::rungeKuttaStep, "rungeKuttaStep", 4);
}

// --- motions --------------------------------------------------------------------------------------------------------

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

/// The number of a vector of one coordinate, or no number.
double only(const VecX& numbers) { return numbers.size() == 1 ? numbers[0] : noNumber; }

bool isOfSize(const State& state, Eigen::Index n) { return state.x.size() == n && state.v.size() == n; }

/// Far beyond where right steps lead: from here on numbers only grow until they are none.
bool hasExploded(const State& state) { return !(sizeOf(state.x) < 1e6 && sizeOf(state.v) < 1e6); }

/// A step of a method with its force and its masses.
using Advance = std::function<State(const State& now, double h)>;

/// The states of so many steps; ends early at one that is no state of as many coordinates, or explodes. The clock is
/// the test's: a step that forgets the time is judged elsewhere.
std::vector<State> march(const Advance& advance, const State& start, double h, int steps) {
  std::vector<State> states = {start};
  for (int i = 0; i < steps && isOfSize(states.back(), start.x.size()) && !hasExploded(states.back()); ++i) {
    State next = advance(states.back(), h);
    next.t = start.t + (i + 1) * h;
    states.push_back(std::move(next));
  }
  return states;
}

Advance advanced(const Step& step, const Force& force, double mass) {
  return [=](const State& now, double h) { return step(force, VecX{{mass}}, now, h); };
}
Advance advancedByVerlet(const PositionForce& force, double mass) {
  return [=](const State& now, double h) { return submission::verletStep(force, VecX{{mass}}, now, h); };
}

}  // namespace

// --- Order ----------------------------------------------------------------------------------------------------------

namespace {

// The motion x = 1 / (1 + t) has x'' = 2 x^3 = -2 x v = 2 / (1 + t)^3: a mixture of the three is a force that depends
// on all, whose solution is known.
constexpr double mass = 1.7;

State known(double t) { return {t, VecX{{1 / (1 + t)}}, VecX{{-1 / ((1 + t) * (1 + t))}}}; }

Asked mixedForce() {
  return {
      "[](double t, const VecX& x, const VecX& v) { return VecX(1.7 * x.array().cube() - 0.85 * x.array() * v.array() "
      "+ "
      "0.85 / std::pow(1 + t, 3)); }",
      [](double t, const VecX& x, const VecX& v) {
        expectSize(x, 1, "positions");
        expectSize(v, 1, "velocities");
        return VecX(1.7 * x.array().cube() - 0.85 * x.array() * v.array() + 0.85 / std::pow(1 + t, 3));
      }};
}

AskedPosition mixedPositionForce() {
  return {"[](double t, const VecX& x) { return VecX(1.7 * x.array().cube() + 1.7 / std::pow(1 + t, 3)); }",
          [](double t, const VecX& x) {
            expectSize(x, 1, "positions");
            return VecX(1.7 * x.array().cube() + 1.7 / std::pow(1 + t, 3));
          }};
}

constexpr double from = 0.3, to = 1.9;  // [s]

double errorOf(const Advance& advance, int steps) {
  const State end = march(advance, known(from), (to - from) / steps, steps).back();
  return std::hypot(only(end.x) - only(known(to).x), only(end.v) - only(known(to).v));
}

/// The next term of the error, h times the first one times a number of about one, moves the measured order by as much
/// as the tolerance has room for.
void expectOrder(const Advance& advance, const char* function, int steps, double order) {
  const double measured = std::log2(errorOf(advance, steps) / errorOf(advance, 2 * steps));
  MUELLE_LABEL(fmt::format("order of {}, by its errors at t = {} s with {} and with {} steps from t = {} s", function,
                           to, steps, 2 * steps, from));
  EXPECT_NUMBER_NEAR(measured, order, 0.15);
}

}  // namespace

TEST(Order, OfExplicitEulerIsOne) {
  MUELLE_PROPERTY("with half the step explicit Euler is off by half, on the motion x = 1 / (1 + t)");
  MUELLE_EXPECT_ANSWERS(explicitEulerStep);
  expectOrder(advanced(submission::explicitEulerStep, mixedForce(), mass), "explicitEulerStep", 32, 1);
}

TEST(Order, OfMidpointIsTwo) {
  MUELLE_PROPERTY("with half the step the midpoint method is off by a quarter, on the motion x = 1 / (1 + t)");
  MUELLE_EXPECT_ANSWERS(midpointStep);
  expectOrder(advanced(submission::midpointStep, mixedForce(), mass), "midpointStep", 32, 2);
}

TEST(Order, OfVerletIsTwo) {
  MUELLE_PROPERTY("with half the step velocity Verlet is off by a quarter, on the motion x = 1 / (1 + t)");
  MUELLE_EXPECT_ANSWERS(verletStep);
  expectOrder(advancedByVerlet(mixedPositionForce(), mass), "verletStep", 32, 2);
}

TEST(Order, OfRungeKuttaIsFour) {
  MUELLE_PROPERTY("with half the step Runge-Kutta is off by a sixteenth, on the motion x = 1 / (1 + t)");
  MUELLE_EXPECT_ANSWERS(rungeKuttaStep);
  expectOrder(advanced(submission::rungeKuttaStep, mixedForce(), mass), "rungeKuttaStep", 16, 4);
}

// --- Stability ------------------------------------------------------------------------------------------------------

namespace {

/// A mass on a spring.
struct Oscillator {
  double m = 1.3, k = 3.7;  // [kg], [N/m]
  double omega() const { return std::sqrt(k / m); }
};

/// The largest factor by which one step makes a motion grow: the spectral radius of the step as a linear map of (x, v).
double growth(const Advance& advance, double h) {
  const State first = advance({0.0, VecX{{0.8}}, VecX{{0.3}}}, h);
  const State second = advance({0.0, VecX{{-0.5}}, VecX{{0.9}}}, h);
  muelle::Mat2 before, after;
  before << 0.8, -0.5, 0.3, 0.9;
  after << only(first.x), only(second.x), only(first.v), only(second.v);
  const muelle::Mat2 map = after * before.inverse();
  const double half = map.trace() / 2, root = half * half - map.determinant();
  return root < 0 ? std::sqrt(map.determinant()) : std::abs(half) + std::sqrt(root);
}

/// The largest h omega up to which no motion grows, by bisection; 0 where even a step of 0.05 / omega makes one grow.
double largestStable(const Advance& advance, double omega) {
  constexpr double rounding = 1e-8;  // midpoint's grow by 8e-7 at 0.05
  const auto isStable = [&](double z) { return growth(advance, z / omega) <= 1 + rounding; };
  double low = 0.05, high = 4;
  if (!isStable(low)) return 0;
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    (isStable(middle) ? low : high) = middle;
  }
  return low;
}

void expectLimit(const Advance& advance, const char* function, double expected) {
  MUELLE_LABEL(fmt::format("largest h omega at which {} makes no undamped swing grow", function));
  EXPECT_NUMBER_NEAR(largestStable(advance, Oscillator().omega()), expected, 0.01);
}

}  // namespace

TEST(Stability, OfExplicitEulerNeedsADamper) {
  MUELLE_PROPERTY("explicit Euler makes every undamped swing grow; with a damper d it is stable up to h = d / k");
  MUELLE_EXPECT_ANSWERS(explicitEulerStep);
  const Oscillator swing;
  const double d = 1.1;  // [N s/m]
  expectLimit(advanced(submission::explicitEulerStep, dampedSpring(swing.k, 0), swing.m), "explicitEulerStep", 0);
  const Advance damped = advanced(submission::explicitEulerStep, dampedSpring(swing.k, d), swing.m);
  MUELLE_LABEL("largest h at which explicitEulerStep makes no damped swing grow, expected d / k", "s");
  EXPECT_NUMBER_NEAR(largestStable(damped, swing.omega()) / swing.omega(), d / swing.k, 0.01 * d / swing.k);
}

TEST(Stability, OfMidpointIsNeverThere) {
  MUELLE_PROPERTY("the midpoint method makes every undamped swing grow, if only a little");
  MUELLE_EXPECT_ANSWERS(midpointStep);
  const Oscillator swing;
  expectLimit(advanced(submission::midpointStep, dampedSpring(swing.k, 0), swing.m), "midpointStep", 0);
}

TEST(Stability, OfVerletEndsAtTwo) {
  MUELLE_PROPERTY("velocity Verlet is stable on an undamped spring up to h omega = 2, and not beyond");
  MUELLE_EXPECT_ANSWERS(verletStep);
  const Oscillator swing;
  expectLimit(advancedByVerlet(spring(swing.k), swing.m), "verletStep", 2);
}

TEST(Stability, OfRungeKuttaEndsAtTwoRootsOfTwo) {
  MUELLE_PROPERTY("Runge-Kutta is stable on an undamped spring up to h omega = 2.83, and not beyond");
  MUELLE_EXPECT_ANSWERS(rungeKuttaStep);
  const Oscillator swing;
  expectLimit(advanced(submission::rungeKuttaStep, dampedSpring(swing.k, 0), swing.m), "rungeKuttaStep", std::sqrt(8));
}

// --- Energies -------------------------------------------------------------------------------------------------------

namespace {

/// Energy of the oscillator, as a part of that at the start.
double energyAfter(const Advance& advance, const Oscillator& swing, double h, int steps) {
  const auto energy = [&](const State& state) {
    return 0.5 * swing.m * only(state.v) * only(state.v) + 0.5 * swing.k * only(state.x) * only(state.x);
  };
  const State start{0.0, VecX{{0.7}}, VecX{{-0.4}}};
  return energy(march(advance, start, h, steps).back()) / energy(start);
}

void expectEnergy(const Step& step, const char* function, double z, double factor) {
  const Oscillator swing;
  constexpr int steps = 40;
  const double expected = std::pow(factor, steps);
  const double got = energyAfter(advanced(step, dampedSpring(swing.k, 0), swing.m), swing, z / swing.omega(), steps);
  MUELLE_LABEL(
      fmt::format("energy after {} steps of {} with h omega = {}, over that at the start", steps, function, z));
  EXPECT_NUMBER_NEAR(got, expected, inStructure(expected) * steps);
}

}  // namespace

TEST(Energies, OfExplicitEulerGrow) {
  MUELLE_PROPERTY("explicit Euler multiplies the energy of an undamped swing by 1 + (h omega)^2 in every step");
  MUELLE_EXPECT_ANSWERS(explicitEulerStep);
  const double z = 0.3;
  expectEnergy(submission::explicitEulerStep, "explicitEulerStep", z, 1 + z * z);
}

TEST(Energies, OfMidpointGrowSlowly) {
  MUELLE_PROPERTY(
      "the midpoint method multiplies the energy of an undamped swing by 1 + (h omega)^4 / 4 in every step");
  MUELLE_EXPECT_ANSWERS(midpointStep);
  const double z = 0.6;
  expectEnergy(submission::midpointStep, "midpointStep", z, 1 + std::pow(z, 4) / 4);
}

TEST(Energies, OfRungeKuttaFadeSlowly) {
  MUELLE_PROPERTY("Runge-Kutta multiplies the energy of an undamped swing by 1 - (h omega)^6 / 72 + (h omega)^8 / 576");
  MUELLE_EXPECT_ANSWERS(rungeKuttaStep);
  const double z = 0.8;
  expectEnergy(submission::rungeKuttaStep, "rungeKuttaStep", z, 1 - std::pow(z, 6) / 72 + std::pow(z, 8) / 576);
}

namespace {

/// Lowest and highest of some numbers; no numbers when one of them is none.
struct Band {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double number) {
    low = std::isnan(number) || std::isnan(low) ? noNumber : std::min(low, number);
    high = std::isnan(number) || std::isnan(high) ? noNumber : std::max(high, number);
  }
};

}  // namespace

TEST(Energies, OfVerletStayInABand) {
  MUELLE_PROPERTY("the energy of velocity Verlet goes up and down within a band, and the band does not get wider");
  MUELLE_EXPECT_OF_USE(verletStep);
  // A spring that gets harder, F = -1.9 x^3: some fifteen swings, in three parts.
  const AskedPosition force("[](double, const VecX& x) { return VecX(-1.9 * x.array().cube()); }",
                            [](double, const VecX& x) {
                              expectSize(x, 1, "positions");
                              return VecX(-1.9 * x.array().cube());
                            });
  constexpr int steps = 360;
  const State start{0.0, VecX{{1.3}}, VecX{{0.4}}};
  const std::vector<State> states = march(advancedByVerlet(force, 0.83), start, 0.16, steps);
  const auto energy = [](const State& state) {
    return 0.5 * 0.83 * std::pow(only(state.v), 2) + 1.9 / 4 * std::pow(only(state.x), 4);
  };
  const auto stateAt = [&](int i) {  // where the motion has ended there is no state
    const auto index = static_cast<std::size_t>(i);
    return index < states.size() ? states[index] : State();
  };
  const auto bandOf = [&](int begin, int end) {
    Band band;
    for (int i = begin; i <= end; ++i) band.include(energy(stateAt(i)));
    return band;
  };
  const Band first = bandOf(0, steps / 3), last = bandOf(2 * steps / 3, steps);
  const double width = first.high - first.low;
  {
    MUELLE_LABEL("highest energy in the last 120 of 360 steps, expected as in the first 120", "J");
    EXPECT_NUMBER_NEAR(last.high, first.high, 0.15 * width);
  }
  MUELLE_LABEL("lowest energy in the last 120 of 360 steps, expected as in the first 120", "J");
  EXPECT_NUMBER_NEAR(last.low, first.low, 0.15 * width);
}

// --- Reversibility --------------------------------------------------------------------------------------------------

TEST(Reversibility, LeadsVerletBackToTheStart) {
  MUELLE_PROPERTY("with the velocities turned round, as many steps of Verlet lead back to where it has started");
  MUELLE_EXPECT_OF_USE(verletStep);
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    Nonlinear coefficients = someForce(random);
    coefficients.a = 0;  // a force that depends on time knows where time goes
    const AskedPosition force = coefficients.withoutVelocity(2);
    const VecX m = someMasses(random, 2);
    const State start = someState(random, 2);
    constexpr int steps = 12;
    const double h = 0.11;
    const Advance advance = [&](const State& now, double step) { return submission::verletStep(force, m, now, step); };
    State turned = march(advance, start, h, steps).back();
    if (isOfSize(turned, 2)) turned.v = -turned.v;
    State back = march(advance, turned, h, steps).back();
    {
      MUELLE_LABEL(fmt::format("positions after {} steps there and {} back, expected as at the start", steps, steps),
                   "m");
      EXPECT_VECTOR_NEAR(back.x, start.x, inStructure(1));
    }
    MUELLE_LABEL(fmt::format("velocities after {} steps there and {} back, expected turned round", steps, steps),
                 "m/s");
    EXPECT_VECTOR_NEAR(back.v, VecX(-start.v), inStructure(1));
  }
}

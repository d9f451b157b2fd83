#include "harness/demo.h"
#include "time_integration.h"

// A mass of 1 kg swings on a spring, x = 0.8 cos t + 0.6 sin t, and the four methods follow it: how exact they are for
// the work they do, and what becomes of the energy.

namespace {

const VecX m{{1.0}};  // [kg]; with a stiffness of 1 N/m the angular frequency is 1 rad/s
const State start{0.0, VecX{{0.8}}, VecX{{0.6}}};
constexpr double period = 2 * M_PI;  // [s]

/// The number of a vector of one, or no number.
double only(const VecX& values) { return values.size() == 1 ? values[0] : NAN; }

/// The spring, which counts how often it is asked. What was asked last is known: a Verlet step begins where the one
/// before has ended.
class CountingSpring {
 public:
  VecX operator()(const VecX& x) {
    if (x.size() == asked_.size() && x == asked_) return answer_;
    ++count_;
    asked_ = x;
    answer_ = -x;
    return answer_;
  }
  double count() const { return count_; }

 private:
  VecX asked_, answer_;
  double count_ = 0.0;
};

struct Method {
  const char* name;
  std::function<State(CountingSpring& spring, const State& now, double h)> step;
  int evaluations;  ///< a step
};

/// One of the methods for forces that may depend on the velocity.
template <class Step>
Method withForce(const char* name, const Step& step, int evaluations) {
  return {name,
          [&step](CountingSpring& spring, const State& now, double h) {
            return step([&spring](double, const VecX& x, const VecX&) { return spring(x); }, m, now, h);
          },
          evaluations};
}

const std::vector<Method> methods = {withForce("explicit Euler", submission::explicitEulerStep, 1),
                                     withForce("midpoint", submission::midpointStep, 2),
                                     {"velocity Verlet",
                                      [](CountingSpring& spring, const State& now, double h) {
                                        return submission::verletStep(
                                            [&spring](double, const VecX& x) { return spring(x); }, m, now, h);
                                      },
                                      1},
                                     withForce("Runge-Kutta 4", submission::rungeKuttaStep, 4)};

/// The states of so many steps of h; fewer when one is no state of one coordinate.
std::vector<State> run(const Method& method, CountingSpring& spring, double h, int steps) {
  std::vector<State> states = {start};
  for (int i = 0; i < steps; ++i) {
    const State next = method.step(spring, states.back(), h);
    if (next.x.size() != 1 || next.v.size() != 1) break;
    states.push_back(next);
  }
  return states;
}

/// Distance from the exact solution, which is the start again after two periods, by the number of evaluations.
muelle::Figure workPrecision() {
  constexpr double duration = 2 * period;
  muelle::Figure figure("work_precision", "Error of a swinging mass after two periods", "evaluations of the force");
  figure.logX();
  auto panel = figure.panel("error [m]");
  panel.logY();
  for (const Method& method : methods) {
    std::vector<double> work, errors;
    for (int evaluations = 32; evaluations <= 1024; evaluations *= 2) {
      CountingSpring spring;
      const int steps = evaluations / method.evaluations;
      const State end = run(method, spring, duration / steps, steps).back();
      work.push_back(spring.count());
      errors.push_back(std::hypot(only(end.x) - only(start.x), only(end.v) - only(start.v)));
    }
    panel.linePoints(method.name, work, errors);
  }
  return figure;
}

double energyOf(const State& state) {
  return 0.5 * only(state.x) * only(state.x) + 0.5 * only(state.v) * only(state.v);
}

/// The same steps for all, over ten periods.
constexpr double h = period / 15;

std::vector<std::vector<State>> swings() {
  std::vector<std::vector<State>> all;
  for (const Method& method : methods) {
    CountingSpring spring;
    all.push_back(run(method, spring, h, 150));
  }
  return all;
}

muelle::Figure energies(const std::vector<std::vector<State>>& all) {
  muelle::Figure figure("energies", "Energy of a swinging mass in steps of a fifteenth of a period", "time [s]");
  auto energy = figure.panel("energy [J]");
  auto error = figure.panel("energy error [J]");
  energy.expect(0.3, 0.7);
  error.logY();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::vector<double> t, E, off;
    for (std::size_t step = 0; step < all[i].size(); ++step) {
      t.push_back(static_cast<double>(step) * h);
      E.push_back(energyOf(all[i][step]));
      off.push_back(std::abs(E.back() - E.front()));
    }
    energy.line(methods[i].name, t, E);
    error.line(methods[i].name, t, off);
  }
  return figure;
}

muelle::Figure phases(const std::vector<std::vector<State>>& all) {
  muelle::Figure figure("phases", "Position and velocity over three periods", "position [m]");
  figure.equalAxes();
  auto panel = figure.panel("velocity [m/s]");
  panel.expectX(-1.0, 1.0).expect(-1.0, 1.0);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::vector<double> x, v;
    for (std::size_t step = 0; step < all[i].size() && step <= 45; ++step) {
      x.push_back(only(all[i][step].x));
      v.push_back(only(all[i][step].v));
    }
    panel.line(methods[i].name, x, v);
  }
  return figure;
}

}  // namespace

MUELLE_DEMO {
  const std::vector<std::vector<State>> all = swings();
  return {workPrecision(), energies(all), phases(all)};
}

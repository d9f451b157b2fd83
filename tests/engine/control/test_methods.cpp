#include "test_methods.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine::testing {

namespace {

using Numbers = std::vector<double>;

/// One evaluation of the first-order problem: dx/dt = v, dv/dt = F/m.
struct Slope {
  Numbers x, v;
};

/// What the methods here share: a slope at a state moved along other slopes.
class SmallMethod : public Integrator {
 public:
  explicit SmallMethod(MethodInfo info) : info_(std::move(info)) {}
  const MethodInfo& info() const override { return info_; }
  void prepare(const DynamicalSystem&, const Tolerance& tolerance) override { tolerance_ = tolerance; }

 protected:
  Slope slopeAt(const DynamicalSystem& system, const State& from, double h, double c, const std::vector<Slope>& slopes,
                const Numbers& weights) {
    State at = from;
    at.t += c * h;
    for (std::size_t j = 0; j < weights.size(); ++j) add(at, h * weights[j], slopes[j]);
    Slope slope{at.v, Numbers(at.x.size())};
    system.force(at.t, at.x, at.v, at.z, slope.v);
    ++work_.forceEvaluations;
    for (std::size_t i = 0; i < slope.v.size(); ++i) slope.v[i] /= system.mass()[i];
    return slope;
  }
  static void add(State& state, double factor, const Slope& slope) {
    for (std::size_t i = 0; i < state.x.size(); ++i) {
      state.x[i] += factor * slope.x[i];
      state.v[i] += factor * slope.v[i];
    }
  }

  MethodInfo info_;
  Tolerance tolerance_;
};

class ClassicalRungeKutta : public SmallMethod {
 public:
  using SmallMethod::SmallMethod;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    std::vector<Slope> k;
    k.push_back(slopeAt(system, from, h, 0.0, k, {}));
    k.push_back(slopeAt(system, from, h, 0.5, k, {0.5}));
    k.push_back(slopeAt(system, from, h, 0.5, k, {0.0, 0.5}));
    k.push_back(slopeAt(system, from, h, 1.0, k, {0.0, 0.0, 1.0}));
    to = from;
    to.t += h;
    const Numbers b = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    for (std::size_t j = 0; j < 4; ++j) add(to, h * b[j], k[j]);
    return {};
  }
};

class BogackiShampine : public SmallMethod {
 public:
  using SmallMethod::SmallMethod;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    std::vector<Slope> k;
    k.push_back(slopeAt(system, from, h, 0.0, k, {}));
    k.push_back(slopeAt(system, from, h, 0.5, k, {0.5}));
    k.push_back(slopeAt(system, from, h, 0.75, k, {0.0, 0.75}));
    k.push_back(slopeAt(system, from, h, 1.0, k, {2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0}));
    to = from;
    to.t += h;
    const Numbers b = {2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0};
    for (std::size_t j = 0; j < 3; ++j) add(to, h * b[j], k[j]);
    const Numbers difference = {-5.0 / 72.0, 1.0 / 12.0, 1.0 / 9.0, -0.125};
    State error = from;
    std::fill(error.x.begin(), error.x.end(), 0.0);
    std::fill(error.v.begin(), error.v.end(), 0.0);
    for (std::size_t j = 0; j < 4; ++j) add(error, h * difference[j], k[j]);
    double worst = 0.0;
    for (std::size_t i = 0; i < from.x.size(); ++i) {
      worst = std::max(worst, ratio(error.x[i], errorScale_.position));
      worst = std::max(worst, ratio(error.v[i], errorScale_.velocity));
    }
    return {true, std::isfinite(worst) ? worst : HUGE_VAL, {}};
  }

 private:
  double ratio(double error, double scale) const {
    const double value = std::abs(error) / (tolerance_.relative * scale);
    return std::isnan(value) ? HUGE_VAL : value;
  }
};

class VerletWithIncrements : public SmallMethod {
 public:
  using SmallMethod::SmallMethod;
  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override {
    const Slope before = slopeAt(system, from, h, 0.0, {}, {});
    const std::size_t n = from.x.size();
    State moved = from;
    increment = from;
    for (std::size_t i = 0; i < n; ++i) {
      increment.x[i] = h * (from.v[i] + 0.5 * h * before.v[i]);
      moved.x[i] += increment.x[i];
    }
    const Slope after = slopeAt(system, moved, h, 1.0, {}, {});
    for (std::size_t i = 0; i < n; ++i) increment.v[i] = 0.5 * h * (before.v[i] + after.v[i]);
    return {};
  }
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    StepResult result = stepIncrement(system, from, h, to);
    for (std::size_t i = 0; i < from.x.size(); ++i) {
      to.x[i] += from.x[i];
      to.v[i] += from.v[i];
    }
    to.t = from.t + h;
    return result;
  }
};

MethodInfo facts(std::string id, int order, int stages, bool adaptive, double imaginaryLimit) {
  MethodInfo info;
  info.id = info.name = std::move(id);
  info.order = order;
  info.stages = stages;
  info.adaptive = adaptive;
  info.imaginaryLimit = imaginaryLimit;
  return info;
}

}  // namespace

std::unique_ptr<Integrator> classicalRungeKutta() {
  return std::make_unique<ClassicalRungeKutta>(facts("rk4 of the tests", 4, 4, false, 2.8284271247461903));
}
std::unique_ptr<Integrator> bogackiShampine() {
  return std::make_unique<BogackiShampine>(facts("bs32 of the tests", 3, 4, true, 1.7320508075688772));
}
std::unique_ptr<Integrator> verletWithIncrements() {
  return std::make_unique<VerletWithIncrements>(facts("verlet of the tests", 2, 2, false, 2.0));
}

}  // namespace muelle::engine::testing

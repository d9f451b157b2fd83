#include "engine/integrators/explicit/engines/spectral_bound.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/methods.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muelle::engine {

namespace {

MethodInfo rungeKuttaChebyshev2Info() {
  MethodInfo info;
  info.id = "rkc2";
  info.name = "Runge-Kutta-Chebyshev 2";
  info.order = 2;
  info.stages = 2;
  info.adaptive = true;
  info.conservesMomentum = true;
  info.stability = Stability::Never;
  info.imaginaryLimit = 0.0;
  info.realLimit = std::numeric_limits<double>::infinity();
  info.formula = "s stages by the recursion of Chebyshev polynomials, s the least with 0.653 (s^2 - 1) above h rho";
  info.source = "Sommeijer, Shampine and Verwer, J. Comput. Appl. Math. 88 (1997) 315-326";
  info.remark =
      "damping-dominated scenes without a matrix: cost grows with the root of h d/m. The number of stages follows the "
      "spectral radius, so real eigenvalues set no limit; undamped modes grow slowly at any step, so only the error "
      "estimate holds it there";
  return info;
}

/// The values that change from stage to stage: T_j(w0), its derivatives, and b_j.
struct Chebyshev {
  double value, first, second, b;
};

class RungeKuttaChebyshev2 : public Integrator {
 public:
  const MethodInfo& info() const override {
    static const MethodInfo facts = rungeKuttaChebyshev2Info();
    return facts;
  }

  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override {
    allowed_ = stepTolerance(tolerance.relative, info().order, errorPower);
    const auto n = static_cast<std::size_t>(system.storage());
    size_ = n;
    for (std::vector<double>* array : {&start_, &end_, &x1_, &v1_, &x2_, &v2_, &a_}) array->assign(n, 0.0);
    bound_.prepare(system);
    restart();
  }

  void restart() override {
    startMark_.clear();
    endMark_.clear();
    accepted_ = false;
    bound_.restart();
  }
  void accept() override { accepted_ = true; }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    provideStart(system, from);
    if (const int at = firstNotFinite(start_); at >= 0) {
      return {.done = false,
              .error = 0.0,
              .failure = fmt::format("the force on {} is not finite at t = {:g} s", laneName(system, at), from.t)};
    }
    const double spectralRadius = bound_.update(system, from, start_, work_);
    const double wanted = 1.0 + std::sqrt(1.54 * h * spectralRadius + 1.0);
    prepareResult(from, h, to);
    if (!(wanted <= mostStages)) {
      return {
          .done = false,
          .error = 0.0,
          .failure = fmt::format("a step of {:g} s against a spectral radius of {:g} 1/s would take {:g} stages; at "
                                 "most {} are taken",
                                 h, spectralRadius, wanted, mostStages)};
    }
    advance(system, from, h, std::max(2, static_cast<int>(wanted)), to);
    system.place(to.t, from.z, to.x, to.v);
    evaluate(system, to.t, to.x, to.v, from.z, end_);
    endMark_.set(to);
    return finiteOrFailure(system, from, to, error(system.inverseMass(), from, to, h));
  }

 private:
  static constexpr int errorPower = 3;     // of h, by which the estimate falls
  static constexpr int mostStages = 4000;  // round-off grows with their square: 1e-9 of the step's change here

  void evaluate(const DynamicalSystem& system, double t, In x, In v, In z, std::vector<double>& a) {
    system.acceleration(t, x, v, z, a);
    ++work_.forceEvaluations;
  }

  void provideStart(const DynamicalSystem& system, const State& from) {
    if (startMark_.matches(from)) {
      bound_.doubt();  // the step is taken again: the spectral radius may have been too small
    } else if (accepted_ && endMark_.matches(from)) {
      std::swap(start_, end_);
    } else {
      evaluate(system, from.t, from.x, from.v, from.z, start_);
    }
    accepted_ = false;
    endMark_.clear();
    startMark_.set(from);
  }

  /// Equations (2.4) to (2.7) of the paper, in the notation of its code.
  void advance(const DynamicalSystem& system, const State& from, double h, int stages, State& to) {
    const double s = stages;
    const double w0 = 1.0 + 2.0 / (13.0 * s * s);
    const double root = std::sqrt(w0 * w0 - 1.0);
    const double arc = s * std::log(w0 + root);
    const double w1 = std::sinh(arc) * (w0 * w0 - 1.0) / (std::cosh(arc) * s * root - w0 * std::sinh(arc));
    const double b = 1.0 / (4.0 * w0 * w0);
    Chebyshev before{1.0, 0.0, 0.0, b}, last{w0, 1.0, 0.0, b};
    double timeBefore = 0.0, timeLast = w1 * b;
    // Stage j - 2 is (x2_, v2_), stage j - 1 is (to.x, to.v), stage j comes to (x1_, v1_).
    std::copy(from.x.begin(), from.x.end(), x2_.begin());
    std::copy(from.v.begin(), from.v.end(), v2_.begin());
    for (std::size_t i = 0; i < size_; ++i) {
      to.x[i] = from.x[i] + h * timeLast * from.v[i];
      to.v[i] = from.v[i] + h * timeLast * start_[i];
    }
    for (int j = 2; j <= stages; ++j) {
      Chebyshev now;
      now.value = 2.0 * w0 * last.value - before.value;
      now.first = 2.0 * w0 * last.first - before.first + 2.0 * last.value;
      now.second = 2.0 * w0 * last.second - before.second + 4.0 * last.first;
      now.b = now.second / (now.first * now.first);
      const double a = 1.0 - last.value * last.b;
      const double mu = 2.0 * w0 * now.b / last.b;
      const double nu = -now.b / before.b;
      const double weight = mu * w1 / w0;
      system.place(from.t + timeLast * h, from.z, to.x, to.v);
      evaluate(system, from.t + timeLast * h, to.x, to.v, from.z, a_);
      for (std::size_t i = 0; i < size_; ++i) {
        // The differences from `from` are combined: mu + nu + (1 - mu - nu) loses digits when s is large.
        x1_[i] =
            from.x[i] + mu * (to.x[i] - from.x[i]) + nu * (x2_[i] - from.x[i]) + h * weight * (to.v[i] - a * from.v[i]);
        v1_[i] =
            from.v[i] + mu * (to.v[i] - from.v[i]) + nu * (v2_[i] - from.v[i]) + h * weight * (a_[i] - a * start_[i]);
      }
      std::swap(x2_, to.x);
      std::swap(to.x, x1_);
      std::swap(v2_, to.v);
      std::swap(to.v, v1_);
      const double time = mu * timeLast + nu * timeBefore + weight * (1.0 - a);
      timeBefore = std::exchange(timeLast, time);
      before = std::exchange(last, now);
    }
  }

  /// 0.8 (y_n - y_n+1) + 0.4 h (y'_n + y'_n+1) over what is allowed, to the power at which it falls with h^2.
  double error(std::span<const double> inverseMass, const State& from, const State& to, double h) const {
    double largest = 0.0;
    const auto look = [&](double y0, double y1, double slopes, double scale) {
      const double estimate = 0.8 * (y0 - y1) + 0.4 * h * slopes;
      largest = larger(largest, errorRatio(estimate, y0, y1, allowed_ * scale));
    };
    for (std::size_t i = 0; i < size_; ++i) {
      if (inverseMass[i] == 0.0) continue;  // moved
      look(from.x[i], to.x[i], from.v[i] + to.v[i], errorScale_.position);
      look(from.v[i], to.v[i], start_[i] + end_[i], errorScale_.velocity);
    }
    return std::pow(largest, 2.0 / errorPower);
  }

  double allowed_ = 1e-6;  // of the estimate, in parts of the motion
  std::size_t size_ = 0;
  std::vector<double> start_, end_;  // accelerations at the ends of the step
  std::vector<double> x1_, v1_, x2_, v2_, a_;
  SpectralBound bound_;
  StateMark startMark_, endMark_;
  bool accepted_ = false;
};

}  // namespace

std::unique_ptr<Integrator> rungeKuttaChebyshev2() { return std::make_unique<RungeKuttaChebyshev2>(); }

}  // namespace muelle::engine

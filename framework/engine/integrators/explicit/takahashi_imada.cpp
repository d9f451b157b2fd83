#include "engine/integrators/explicit/engines/stage_kernels.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/methods.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

namespace {

MethodInfo takahashiImadaInfo() {
  MethodInfo info;
  info.id = "takahashi_imada";
  info.name = "Takahashi-Imada";
  info.order = 4;
  info.stages = 2;
  info.reversible = true;
  info.conservesMomentum = true;
  info.processed = true;
  info.imaginaryLimit = 3.46410161513775458705;  // 2 sqrt(3)
  info.realLimit = 0.0;                          // no damping can act on it
  info.needs.velocityFreeForce = true;
  info.formula =
      "velocity Verlet with the force at q + h^2/12 a(q); x = q + h^2/12 a(q) and v = p - h^2/12 da/dt at outputs";
  info.source =
      "Takahashi and Imada, J. Phys. Soc. Jpn. 53 (1984) 3765; Rowlands, J. Comput. Phys. 97 (1991) 235; processing: "
      "Lopez-Marcos, Sanz-Serna and Skeel, SIAM J. Sci. Comput. 18 (1997) 223";
  info.remark =
      "undamped scenes whose steps stability binds, errors of 1e-3 to 1e-6: at 1.73 times the step of velocity Verlet, "
      "for two forces, its error is far smaller. What is kept in a band is the energy of the map that runs inside; it "
      "is volume-preserving and reversible, and symplectic to order 4. A change of the step starts it anew";
  return info;
}

/// Kick, drift, kick with the modified force a(q + h^2/12 a(q)) on states (q, p) inside, from which the processor gives
/// those outside: x = q + h^2/12 a(q), v = p - h^2/12 da/dt. Order 4 for those outside only.
///
/// da/dt along the motion is that of the parabola through a(q) at the last three states, whose error h^2 makes one of
/// h^4 in v; after a start it is a central difference of forces. The way in solves the processor's equations by
/// iteration, so that what comes out again is what went in.
class TakahashiImada : public Integrator {
 public:
  const MethodInfo& info() const override {
    static const MethodInfo facts = takahashiImadaInfo();
    return facts;
  }

  void prepare(const DynamicalSystem& system, const Tolerance&) override {
    if (system.forceUsesVelocity()) {
      throw std::invalid_argument(
          "Takahashi-Imada needs a force that does not depend on the velocity: remove damping, drag and friction, or "
          "use "
          "velocity_verlet or dop853");
    }
    n_ = static_cast<std::size_t>(system.storage());
    kernels_ = &stageKernels(n_);
    for (Inner* inner : {&start_, &end_}) {
      for (std::vector<double>* array : {&inner->q, &inner->p, &inner->a, &inner->modified}) array->assign(n_, 0.0);
    }
    for (std::vector<double>* array : {&before_, &shifted_, &slope_, &forward_, &backward_}) array->assign(n_, 0.0);
    restart();
  }

  void restart() override {
    start_.mark.clear();
    end_.mark.clear();
    accepted_ = hasBefore_ = false;
  }
  void accept() override { accepted_ = true; }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    provideStart(system, from, h);
    prepareResult(from, h, to);
    const double *const p = start_.p.data(), *const a = start_.modified.data();
    kernels_->halfKickDrift(n_, start_.q.data(), p, a, h, end_.q.data(), nullptr);
    system.place(to.t, from.z, end_.q, end_.p);
    evaluate(system, to.t, end_.q, end_.p, from.z, end_.a);
    evaluateModified(system, to.t, from.z, h, end_);
    kernels_->twoHalfKicks(n_, p, a, end_.modified.data(), h, end_.p.data());
    slopeAtEnd(system, to.t, from.z, h);
    const double e = h * h / 12.0;
    double zeros = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      to.x[i] = end_.q[i] + e * end_.a[i];
      to.v[i] = end_.p[i] - e * slope_[i];
      zeros += 0.0 * to.x[i] + 0.0 * to.v[i];
    }
    system.place(to.t, from.z, to.x, to.v);
    end_.mark.set(to);
    if (zeros == 0.0) return {};
    return finiteOrFailure(system, from, to, 0.0);
  }

 private:
  struct Inner {
    StateMark mark;                ///< of the state outside
    std::vector<double> q, p;      ///< state inside
    std::vector<double> a;         ///< at q
    std::vector<double> modified;  ///< at q + h^2/12 a
  };

  void evaluate(const DynamicalSystem& system, double t, In q, In p, In z, std::vector<double>& a) {
    system.acceleration(t, q, p, z, a);
    ++work_.forceEvaluations;
  }

  /// At shifted_ and another time than that of the state inside.
  void evaluateShifted(const DynamicalSystem& system, double t, In z, const Inner& inner, std::vector<double>& a) {
    slope_ = inner.p;  // for moved nodes to have velocities of their own in
    system.place(t, z, shifted_, slope_);
    evaluate(system, t, shifted_, slope_, z, a);
  }

  void evaluateModified(const DynamicalSystem& system, double t, In z, double h, Inner& inner) {
    const double e = h * h / 12.0;
    for (std::size_t i = 0; i < n_; ++i) shifted_[i] = inner.q[i] + e * inner.a[i];
    evaluate(system, t, shifted_, inner.p, z, inner.modified);
  }

  /// The state inside that belongs to `from`: the end of the step before, the one from which a step was tried already,
  /// or a new one.
  void provideStart(const DynamicalSystem& system, const State& from, double h) {
    const bool same = std::abs(h - h_) <= 1e-9 * h;  // lengths are differences of rounded times
    if (same && accepted_ && end_.mark.matches(from)) {
      before_.swap(start_.a);
      std::swap(start_, end_);
      hasBefore_ = true;
    } else if (!(same && start_.mark.matches(from))) {
      enter(system, from, h);
    }
    accepted_ = false;
    end_.mark.clear();
    h_ = h;
  }

  /// q + h^2/12 a(q) = x and p - h^2/12 da/dt = v, by iterations that shrink the error by (h omega)^2/12 each.
  void enter(const DynamicalSystem& system, const State& from, double h) {
    const double e = h * h / 12.0;
    start_.q = from.x;
    start_.p = from.v;
    constexpr int iterations = 4;
    for (int k = 0; k < iterations; ++k) {
      evaluate(system, from.t, start_.q, from.v, from.z, start_.a);
      for (std::size_t i = 0; i < n_; ++i) start_.q[i] = from.x[i] - e * start_.a[i];
      system.place(from.t, from.z, start_.q, start_.p);
    }
    evaluate(system, from.t, start_.q, from.v, from.z, start_.a);
    for (int k = 0; k < 3; ++k) {
      centralSlope(system, from.t, from.z, h, start_);
      for (std::size_t i = 0; i < n_; ++i) start_.p[i] = from.v[i] + e * slope_[i];
      system.place(from.t, from.z, start_.q, start_.p);
    }
    evaluateModified(system, from.t, from.z, h, start_);
    start_.mark.set(from);
    hasBefore_ = false;
  }

  /// slope_ = da/dt along (1, p) at a state inside.
  void centralSlope(const DynamicalSystem& system, double t, In z, double h, const Inner& inner) {
    const double s = 1e-3 * h;
    for (std::size_t i = 0; i < n_; ++i) shifted_[i] = inner.q[i] + s * inner.p[i];
    evaluateShifted(system, t + s, z, inner, forward_);
    for (std::size_t i = 0; i < n_; ++i) shifted_[i] = inner.q[i] - s * inner.p[i];
    evaluateShifted(system, t - s, z, inner, backward_);
    for (std::size_t i = 0; i < n_; ++i) slope_[i] = (forward_[i] - backward_[i]) / (2.0 * s);
  }

  void slopeAtEnd(const DynamicalSystem& system, double t, In z, double h) {
    if (!hasBefore_) return centralSlope(system, t, z, h, end_);
    const double w = 0.5 / h;
    for (std::size_t i = 0; i < n_; ++i) slope_[i] = w * (3.0 * end_.a[i] - 4.0 * start_.a[i] + before_[i]);
  }

  std::size_t n_ = 0;
  const StageKernels* kernels_ = nullptr;
  Inner start_, end_;
  std::vector<double> before_;  ///< a at the state before start_
  std::vector<double> shifted_, slope_, forward_, backward_;
  double h_ = 0.0;  ///< of the states inside
  bool accepted_ = false, hasBefore_ = false;
};

}  // namespace

std::unique_ptr<Integrator> takahashiImada() { return std::make_unique<TakahashiImada>(); }

}  // namespace muelle::engine

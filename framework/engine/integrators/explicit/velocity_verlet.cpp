#include "engine/integrators/explicit/engines/drag_factors.h"
#include "engine/integrators/explicit/engines/kick.h"
#include "engine/integrators/explicit/engines/lane_arrays.h"
#include "engine/integrators/explicit/engines/stage_kernels.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/methods.h"

#include <algorithm>

namespace muelle::engine {

namespace {

MethodInfo velocityVerletInfo() {
  MethodInfo info;
  info.id = "velocity_verlet";
  info.name = "velocity Verlet";
  info.order = 2;
  info.stages = 1;
  info.symplectic = true;
  info.reversible = true;
  info.conservesMomentum = true;
  info.conservesAngularMomentum = true;
  info.imaginaryLimit = 2.0;
  info.realLimit = 1.0;
  info.formula = "x+ = x + h v + h^2/2 a;  v+ = v + h/2 (a + a+)";
  info.source = "Swope et al., J. Chem. Phys. 76 (1982) 637; with drag: Cox and Matthews, J. Comput. Phys. 176 (2002)";
  info.remark =
      "the default for undamped springs: second order for one force a step, energy in a band for ever. A linear drag "
      "is integrated exactly and sets no limit on the step. Other velocity-dependent forces are evaluated at the "
      "velocity that the last force predicts, v + h/2 a at the middle of the step: second order, one evaluation a "
      "step, "
      "stable to h d/m = 2 zeta h omega = 1, and no longer symplectic";
  return info;
}

/// Velocity Verlet. With a drag d it integrates m v' = -d v + F exactly for the force F = F(t_n) in the position and
/// for the force's linear interpolant in the velocity. With c = h d/m and phi1, phi2 of DragFactors:
///
///     x+ = x + h phi1 v + h^2 phi2 a
///     v+ = exp(-c) v + h ((phi1 - phi2) a + phi2 a+)
///
/// which is velocity Verlet for c -> 0, and x' = v = F/d for c -> infinity: a kick before or after the decay would get
/// the velocity wrong by a factor c/2 there.
///
/// A force that uses the velocity takes the one that the step would end with under the force of its beginning, v + h a:
/// off by h/2 (a - a+), of second order. That a+ is also what the next step begins with, so that there is one
/// evaluation a step. With damping alone, z = h d/m: (v, h a) goes by a matrix of trace 1 - 3z/2 and determinant -z/2,
/// whose eigenvalues stay in the unit circle up to z = 1.
class VelocityVerlet : public Integrator {
 public:
  const MethodInfo& info() const override {
    static const MethodInfo facts = velocityVerletInfo();
    return facts;
  }

  void prepare(const DynamicalSystem& system, const Tolerance&) override {
    kick_.prepare(system);
    kernels_ = &stageKernels(static_cast<std::size_t>(system.storage()));
    simple_ = system.drag() == nullptr;
    factors_.forget();
    if (system.drag() != nullptr) factors_.update(system, 0.0);
    const auto lanes = static_cast<std::size_t>(system.storage());
    predicted_.assign(1, lanes);
    for (std::vector<double>* array : {&dx_, &dv_, &low_}) array->assign(lanes, 0.0);
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    return simple_ ? simpleStep(system, from, h, to) : draggedStep(system, from, h, to);
  }

  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override {
    // The force at the end is that of the compensated sum, which is where the next step starts: without the low part
    // the energy of an oscillator drifts three times as fast.
    std::copy(increment.x.begin(), increment.x.end(), low_.begin());
    advance(system, from, h, increment);
    for (std::size_t i = 0; i < dv_.size(); ++i) increment.v[i] = from.v[i] + dv_[i];
    system.place(increment.t, from.z, increment.x, increment.v);
    kick_.finish(increment);
    StepResult result = finiteOrFailure(system, from, increment, 0.0);
    std::fill(low_.begin(), low_.end(), 0.0);
    increment.x = dx_;
    increment.v = dv_;
    return result;
  }

  void restart() override { kick_.restart(); }
  void accept() override { kick_.accept(); }

 private:
  /// Without drag, in two passes.
  StepResult simpleStep(const DynamicalSystem& system, const State& from, double h, State& to) {
    kick_.start(system, from, work_);
    prepareResult(from, h, to);
    const std::size_t n = from.x.size();
    double sum = kernels_->halfKickDrift(n, from.x.data(), from.v.data(), kick_.acceleration(), h, to.x.data(),
                                         kick_.usesVelocity() ? predicted_.data(0) : nullptr);
    system.place(to.t, from.z, to.x, predicted_[0]);
    kick_.evaluate(system, to.t, to.x, predicted_[0], from.z, work_);
    sum += kernels_->twoHalfKicks(n, from.v.data(), kick_.before(), kick_.acceleration(), h, to.v.data());
    system.place(to.t, from.z, to.x, to.v);
    kick_.finish(to);
    if (isFinite(sum)) return {};
    return finiteOrFailure(system, from, to, 0.0);
  }

  /// With drag. Not taken into step(), whose other way, of fewer instructions, would begin with all that this one
  /// needs.
  [[gnu::noinline]] StepResult draggedStep(const DynamicalSystem& system, const State& from, double h, State& to) {
    advance(system, from, h, to);
    for (std::size_t i = 0; i < dv_.size(); ++i) to.v[i] = from.v[i] + dv_[i];
    system.place(to.t, from.z, to.x, to.v);
    kick_.finish(to);
    return finiteOrFailure(system, from, to, 0.0);
  }

  void advance(const DynamicalSystem& system, const State& from, double h, State& to) {
    kick_.start(system, from, work_);
    prepareResult(from, h, to);
    if (system.drag() != nullptr) {
      factors_.update(system, h);
      advance(
          system, from, h, to, [this](std::size_t i) { return factors_.loss(i); },
          [this](std::size_t i) { return factors_.phi1(i); }, [this](std::size_t i) { return factors_.phi2(i); });
    } else {
      advance(
          system, from, h, to, [](std::size_t) { return 0.0; }, [](std::size_t) { return 1.0; },
          [](std::size_t) { return 0.5; });
    }
  }

  /// The changes of x and v over the step, in dx_ and dv_.
  template <typename Loss, typename Phi1, typename Phi2>
  void advance(const DynamicalSystem& system, const State& from, double h, State& to, Loss loss, Phi1 phi1, Phi2 phi2) {
    const std::size_t n = dv_.size();
    double* const predicted = predicted_.data(0);
    const double* a = kick_.acceleration();
    for (std::size_t i = 0; i < n; ++i) {
      const double decayed = phi1(i) * from.v[i], kick = h * (phi2(i) * a[i]), mean = decayed + kick;
      dx_[i] = h * mean + h * lostIn(mean, decayed, kick);
      to.x[i] = from.x[i] + (dx_[i] + low_[i]);
      // What the first force does to the velocity; predicted: the velocity if the force stayed the same.
      dv_[i] = loss(i) * from.v[i] + h * ((phi1(i) - phi2(i)) * a[i]);
      predicted[i] = from.v[i] + (dv_[i] + h * (phi2(i) * a[i]));
    }
    system.place(to.t, from.z, to.x, predicted_[0]);
    kick_.evaluate(system, to.t, to.x, predicted_[0], from.z, work_);
    a = kick_.acceleration();
    for (std::size_t i = 0; i < n; ++i) dv_[i] += h * (phi2(i) * a[i]);
  }

  const StageKernels* kernels_ = nullptr;
  bool simple_ = false;
  Kick kick_;
  DragFactors factors_;
  LaneArrays predicted_;  // velocities, one array
  std::vector<double> dx_, dv_;
  std::vector<double> low_;  // of the positions, 0 unless sums are compensated
};

}  // namespace

std::unique_ptr<Integrator> velocityVerlet() { return std::make_unique<VelocityVerlet>(); }

}  // namespace muelle::engine

#include "engine/integrators/explicit/engines/lane_arrays.h"
#include "engine/integrators/explicit/engines/stage_kernels.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo symplecticEulerInfo() {
  MethodInfo info;
  info.id = "symplectic_euler";
  info.name = "symplectic Euler";
  info.order = 1;
  info.stages = 1;
  info.symplectic = true;
  info.conservesMomentum = true;
  info.conservesAngularMomentum = true;
  info.imaginaryLimit = 2.0;
  info.realLimit = 2.0;
  info.formula = "v+ = v + h F(t, x, v) / m;  x+ = x + h v+";
  info.source = "Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), I.1.2";
  info.remark =
      "the cheapest method that keeps an oscillator alive; first order in positions and velocities, but its phase is "
      "that of velocity Verlet. With damping it is stable up to (h omega)^2 + 2 h d/m = 4. Velocity-dependent forces "
      "end its symplecticity and the conservation of angular momentum";
  return info;
}

class SymplecticEuler : public Integrator {
 public:
  const MethodInfo& info() const override {
    static const MethodInfo facts = symplecticEulerInfo();
    return facts;
  }

  void prepare(const DynamicalSystem& system, const Tolerance&) override {
    acceleration_.assign(1, static_cast<std::size_t>(system.storage()));
    kernels_ = &stageKernels(acceleration_.lanes());
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    prepareResult(from, h, to);
    system.acceleration(from.t, from.x, from.v, from.z, acceleration_[0]);
    ++work_.forceEvaluations;
    const double sum = kernels_->kickDrift(acceleration_.lanes(), from.x.data(), from.v.data(), acceleration_.data(0),
                                           h, to.x.data(), to.v.data());
    system.place(to.t, from.z, to.x, to.v);
    if (isFinite(sum)) return {};
    return finiteOrFailure(system, from, to, 0.0);
  }

  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override {
    StepResult result = step(system, from, h, increment);
    const Out a = acceleration_[0];
    for (std::size_t i = 0; i < a.size(); ++i) {
      increment.v[i] = h * a[i];
      const double v = from.v[i] + increment.v[i];
      increment.x[i] = h * v + h * lostIn(v, from.v[i], increment.v[i]);
    }
    return result;
  }

 private:
  const StageKernels* kernels_ = nullptr;
  LaneArrays acceleration_;  // one array
};

}  // namespace

std::unique_ptr<Integrator> symplecticEuler() { return std::make_unique<SymplecticEuler>(); }

}  // namespace muelle::engine

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
    acceleration_.assign(static_cast<std::size_t>(system.storage()), 0.0);
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    prepareResult(from, h, to);
    system.acceleration(from.t, from.x, from.v, from.z, acceleration_);
    ++work_.forceEvaluations;
    const double notFinite = stageKernels(acceleration_.size())
                                 .kickDrift(acceleration_.size(), from.x.data(), from.v.data(), acceleration_.data(), h,
                                            to.x.data(), to.v.data());
    system.place(to.t, from.z, to.x, to.v);
    if (notFinite == 0.0) return {};
    return finiteOrFailure(system, from, to, 0.0);
  }

  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override {
    StepResult result = step(system, from, h, increment);
    for (std::size_t i = 0; i < acceleration_.size(); ++i) {
      increment.v[i] = h * acceleration_[i];
      const double v = from.v[i] + increment.v[i];
      increment.x[i] = h * v + h * lostIn(v, from.v[i], increment.v[i]);
    }
    return result;
  }

 private:
  std::vector<double> acceleration_;
};

}  // namespace

std::unique_ptr<Integrator> symplecticEuler() { return std::make_unique<SymplecticEuler>(); }

}  // namespace muelle::engine

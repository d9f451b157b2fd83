#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>

namespace muelle::plots {

namespace {

constexpr double duration = 10.0;

engine::RunResult adaptiveRun(const engine::ModelSystem& system, const std::string& id, double tolerance) {
  engine::RunOptions options;
  options.duration = options.outputInterval = duration;
  options.tolerance.relative = tolerance;
  options.checkStability = options.checkNumericalDamping = false;
  return engine::simulate(system, *engine::makeMethod(id), system.initialState(), options);
}

struct Points {
  std::vector<double> error, evaluations, seconds;
};

/// The shortest of a few runs: what the machine does besides only makes them longer.
void add(Points& points, const std::function<engine::RunResult()>& run, const Vec3& exact,
         const engine::ModelSystem& system) {
  engine::RunResult result = run();
  for (int i = 0; i < 4; ++i) result.wallTime = std::min(result.wallTime, run().wallTime);
  // A run that fails, or is off by the pendulum's length, stands at the margin.
  const double error = result.failed() ? 1.0 : (system.position(result.last, 1) - exact).norm();
  points.error.push_back(std::min(error, 1.0));
  points.evaluations.push_back(static_cast<double>(result.work.forceEvaluations));
  points.seconds.push_back(result.wallTime);
}

/// Steps or tolerances from the coarsest on, until the error comes near to that of the reference.
Points sweep(const engine::ModelSystem& system, const std::string& id, const Vec3& exact, double smallest) {
  Points points;
  const bool adaptive = engine::methodInfo(id).adaptive;
  const int most = adaptive ? 14 : 11;
  double h = 0.2, tolerance = 1e-1;
  for (int i = 0; i < most && (i == 0 || points.error.back() > smallest); ++i, h *= 0.5, tolerance *= 0.1) {
    const auto once = [&] {
      return adaptive ? adaptiveRun(system, id, tolerance) : run(system, id, h, duration, duration);
    };
    add(points, once, exact, system);
  }
  return points;
}

}  // namespace

/// "Which integrator, which step?" Speed against error: force evaluations and wall time that an error costs. The
/// reference comes from two methods of high order at tight tolerance, whose difference is its error; what is shown is
/// at least a hundred times larger.
Figure work_precision() {
  const auto system = engine::build(elasticPendulum());
  const Vec3 exact = system->position(adaptiveRun(*system, "nystrom12", 1e-15).last, 1);
  const double doubt = (system->position(adaptiveRun(*system, "dop853", 1e-14).last, 1) - exact).norm();
  const double smallest = std::max(100.0 * doubt, 1e-12);
  Figure figure("work_precision", "Speed against error: the more digits are asked for, the more a high order pays",
                "position error after 10 s [m]");
  figure.slide(2);
  auto evaluations = figure.panel("evaluations");
  evaluations.heading(fmt::format("of the force (reference good to {:.0e} m)", doubt));
  auto seconds = figure.panel("wall time [s]");
  seconds.heading("measured (at 1 m: as far off, or failed)");
  int colour = 0;
  for (const std::string id :
       {"velocity_verlet", "runge_kutta_4", "dormand_prince_5", "implicit_midpoint", "kahan_li_8", "nystrom12"}) {
    const Points points = sweep(*system, id, exact, smallest);
    const std::string& name = engine::methodInfo(id).name;
    // The names stand half here, half there.
    evaluations.linePoints(colour < 3 ? name : "", points.error, points.evaluations).colour(colour);
    seconds.linePoints(colour < 3 ? "" : name, points.error, points.seconds).colour(colour);
    ++colour;
  }
  for (auto* panel : {&evaluations, &seconds}) panel->logX().logY().xRange(smallest, 2.0);
  return figure;
}

}  // namespace muelle::plots

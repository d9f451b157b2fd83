#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::plots {

namespace {

/// Hard case H04, regular: an elastic pendulum for 10 s.
engine::Model pendulum() {
  engine::Model model;
  model.dimension = 2;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x = {0.3, 0.0, -1.0};
  model.springs.push_back({.a = 1, .b = 0, .k = 100.0, .L0 = 1.0});
  return model;
}

constexpr double duration = 10.0;

engine::RunResult adaptiveRun(const engine::ModelSystem& system, const std::string& id, double tolerance) {
  engine::RunOptions options;
  options.duration = options.outputInterval = duration;
  options.tolerance.relative = options.tolerance.absolute = tolerance;
  options.checkStability = options.checkNumericalDamping = false;
  return engine::simulate(system, *engine::makeMethod(id), system.initialState(), options);
}

struct Points {
  std::vector<double> error, evaluations, seconds;
};

void add(Points& points, const engine::RunResult& result, const Vec3& exact, const engine::ModelSystem& system) {
  // A run that fails, or is off by more than the pendulum's length, stands at the margin.
  const double error = result.failed() ? 10.0 : (system.position(result.last, 1) - exact).norm();
  points.error.push_back(std::min(error, 10.0));
  points.evaluations.push_back(static_cast<double>(result.work.forceEvaluations));
  points.seconds.push_back(result.wallTime);
}

Points sweep(const engine::ModelSystem& system, const std::string& id, const Vec3& exact) {
  Points points;
  if (engine::methodInfo(id).adaptive) {
    for (double tolerance = 1e-3; tolerance > 1e-14; tolerance *= 0.1) {
      add(points, adaptiveRun(system, id, tolerance), exact, system);
    }
  } else {
    for (double h = 0.1; h > 2e-4; h *= 0.5) add(points, run(system, id, h, duration, duration), exact, system);
  }
  return points;
}

}  // namespace

/// "Which integrator, which step?" Speed against error: force evaluations and wall time that an error costs. The
/// reference comes from two methods of high order at tight tolerance, whose difference is its error.
Figure work_precision() {
  const auto system = engine::build(pendulum());
  const Vec3 exact = system->position(adaptiveRun(*system, "nystrom12", 1e-15).last, 1);
  const double doubt = (system->position(adaptiveRun(*system, "dop853", 1e-14).last, 1) - exact).norm();
  Figure figure(
      "work_precision",
      fmt::format("Speed against error: the higher the order, the cheaper the digits (reference: {:.0e} m)", doubt),
      "position error after 10 s [m]");
  figure.slide(2);
  const std::vector<std::string> ids = {"velocity_verlet",   "runge_kutta_4", "dormand_prince_5",
                                        "implicit_midpoint", "kahan_li_8",    "nystrom12"};
  std::vector<Points> sweeps;
  for (const std::string& id : ids) sweeps.push_back(sweep(*system, id, exact));
  auto evaluations = figure.panel("force evaluations");
  evaluations.heading("counted").logX().logY();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    evaluations.linePoints(engine::methodInfo(ids[i]).name, sweeps[i].error, sweeps[i].evaluations);
  }
  auto seconds = figure.panel("wall time [s]");
  seconds.heading("measured").logX().logY();
  for (const Points& points : sweeps) seconds.linePoints("", points.error, points.seconds);
  for (auto* panel : {&evaluations, &seconds}) panel->xRange(1e-14, 20.0);
  evaluations.note(1e-13, 100, "right margin: failed, or off by more than 1 m");
  return figure;
}

}  // namespace muelle::plots

#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <ctime>

namespace muelle::plots::work_precision {

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

/// The processor's time that it has worked for this process, so that what else runs does not count.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void add(Points& points, const engine::RunResult& result, double seconds, const Vec3& exact,
         const engine::ModelSystem& system) {
  // A run that fails, or is off by the pendulum's length, stands at the margin.
  const double error = result.failed() ? 1.0 : (system.position(result.last, 1) - exact).norm();
  points.error.push_back(std::min(error, 1.0));
  points.evaluations.push_back(static_cast<double>(result.work.forceEvaluations));
  points.seconds.push_back(std::max(seconds, 1e-6));  // the resolution of the clock
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
    if (i == 0) once();  // the first run has to fill the caches
    const double before = processorSeconds();
    const engine::RunResult result = once();
    add(points, result, processorSeconds() - before, exact, system);
  }
  if (points.error.back() < smallest) {  // the reference is not good enough for it
    for (auto* values : {&points.error, &points.evaluations, &points.seconds}) values->pop_back();
  }
  return points;
}

constexpr const char* methods[] = {"velocity_verlet",   "runge_kutta_4", "dormand_prince_5",
                                   "implicit_midpoint", "kahan_li_8",    "nystrom12"};
constexpr const char* names[] = {"Verlet", "RK4", "DP5", "midpoint", "Kahan-Li 8", "Nyström 12"};
constexpr int runs = 5;

/// Each run's time is the shortest of five: what the machine does besides only makes it longer. The five are far apart,
/// each in a sweep of all methods, so that a busy second spoils only one.
std::vector<Points> sweepAll(const engine::ModelSystem& system, const Vec3& exact, double smallest) {
  std::vector<Points> all;
  for (const char* id : methods) all.push_back(sweep(system, id, exact, smallest));
  for (int again = 1; again < runs; ++again) {
    for (std::size_t m = 0; m < all.size(); ++m) {
      const Points once = sweep(system, methods[m], exact, smallest);
      for (std::size_t i = 0; i < once.seconds.size(); ++i) {
        all[m].seconds[i] = std::min(all[m].seconds[i], once.seconds[i]);
      }
    }
  }
  return all;
}

}  // namespace

/// "Which integrator, which step?" Speed against error: force evaluations and processor time that an error costs. The
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
  auto evaluations = figure.panel("");
  evaluations.heading(fmt::format("evaluations of the force (reference: {} m)", asPower(doubt)));
  auto seconds = figure.panel("");
  seconds.heading(fmt::format("processor time [s], shortest of {} runs", runs));
  const std::vector<Points> all = sweepAll(*system, exact, smallest);
  for (std::size_t m = 0; m < all.size(); ++m) {
    evaluations.linePoints(names[m], all[m].error, all[m].evaluations);
    seconds.linePoints(names[m], all[m].error, all[m].seconds);
  }
  evaluations.note(2.0 * smallest, 20.0, "at 1 m: as far off, or failed");
  for (auto* panel : {&evaluations, &seconds}) panel->logX().logY().xRange(smallest, 2.0);
  return figure;
}

}  // namespace muelle::plots::work_precision

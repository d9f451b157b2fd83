#include "lab/advise/pilot.h"

#include "engine/contact/box.h"
#include "engine/contact/plane.h"
#include "engine/contact/sphere.h"
#include "engine/control/motion_frame.h"
#include "engine/control/run_checks.h"
#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"
#include "lab/bench/stopwatch.h"
#include "lab/run/run_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr long long sampleCount = 240;  // has many divisors
constexpr double mostNumbers = 2e6;     // of all rows of a run: 16 MB
constexpr double mostOftenLooks = 1000.0;
constexpr double never = std::numeric_limits<double>::infinity();

/// Asks the clocks rarely where steps are short.
class Deadline {
 public:
  explicit Deadline(const PilotLimits& limits)
      : seconds_(limits.seconds),
        ofProcessor_(bench::processorTime() + limits.ofProcessor),
        begin_(Clock::now()),
        last_(begin_) {}

  bool passed() {
    if (++calls_ < stride_) return false;
    calls_ = 0;
    const Clock::time_point now = Clock::now();
    if (std::chrono::duration<double>(now - last_).count() < 1e-3) stride_ = std::min(2 * stride_, 1024);
    last_ = now;
    return std::chrono::duration<double>(now - begin_).count() > seconds_ || bench::processorTime() > ofProcessor_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_, ofProcessor_;
  Clock::time_point begin_, last_;
  int calls_ = 0, stride_ = 1;
};

/// The engine's own gap [m], below 0 inside.
double gapOf(const Obstacle& obstacle, const Vec3& x, double t) {
  const Vec3 r = x - obstacle.centre - obstacle.velocity * std::min(t, obstacle.stopTime);
  if (obstacle.kind == Obstacle::Kind::Plane) return Plane<3>{obstacle.normal.normalized()}.touch(r, 0).gap;
  if (obstacle.kind == Obstacle::Kind::Sphere) return Sphere<3>{obstacle.radius}.touch(r, 0).gap;
  return Box<3>{obstacle.halfSize}.touch(r, 0).gap;
}

/// How near free nodes come to each obstacle.
class GapWatch {
 public:
  GapWatch(const ModelSystem& system, const std::vector<Obstacle>& obstacles, PilotRun& run)
      : system_(system), obstacles_(obstacles), run_(run) {
    run.leastGap.assign(obstacles.size(), never);
    run.sureGap = run.leastGap;
    run.firstTouch.assign(run.leastGap.size(), never);
  }

  void see(const State& state, double step) {
    const Model& model = system_.model();
    if (obstacles_.empty()) return;
    for (int node = 0; node < system_.nodeCount(); ++node) {
      if (!isFree(model.nodes[static_cast<std::size_t>(node)])) continue;
      const Vec3 x = placeOf(system_, state, node), v = system_.velocity(state, node);
      for (std::size_t i = 0; i < obstacles_.size(); ++i) {
        const Obstacle& obstacle = obstacles_[i];
        const Vec3 w = state.t < obstacle.stopTime ? obstacle.velocity : Vec3::Zero();
        const double gap = gapOf(obstacle, x, state.t);
        if (gap <= 0.0 && state.t < run_.firstTouch[i]) run_.firstTouch[i] = state.t;
        run_.leastGap[i] = std::min(run_.leastGap[i], gap);
        run_.sureGap[i] = std::min(run_.sureGap[i], gap - step * (v - w).norm());
      }
    }
  }

 private:
  const ModelSystem& system_;
  const std::vector<Obstacle>& obstacles_;
  PilotRun& run_;
};

/// Takes the rows of a run as it goes.
class RowRecorder {
 public:
  /// \param dense  by dense output at the times; else at the first end of a step behind each of them
  RowRecorder(const ModelSystem& system, const std::vector<double>& times, bool dense, const PilotLimits& limits,
              PilotRun& run)
      : system_(system), times_(times), dense_(dense), limits_(limits), run_(run) {}

  void see(Simulation& simulation, const Advance& advance) {
    const bool isStep = advance.kind == Advance::Kind::Step;
    if (dense_) {
      for (; isStep && isDue(simulation.time()); ++next_) {
        run_.rows.add(system_, simulation.at(std::min(simulation.time(), times_[next_])));
      }
    } else if (limits_.looksOften) {
      if (isStep) seeEvery(simulation.state());
    } else if (isDue(simulation.time())) {
      // A step that passes over several of the times is looked at once.
      while (isDue(simulation.time())) ++next_;
      run_.rows.add(system_, simulation.state());
      if (limits_.isReference) run_.states.push_back(simulation.state());
    }
  }
  bool hasAll() const { return next_ >= times_.size(); }

 private:
  bool isDue(double t) const { return next_ < times_.size() && times_[next_] <= t + 1e-12 * times_.back(); }

  /// Every end of a step; of many steps every second one, and so on.
  void seeEvery(const State& state) {
    if (++steps_ % stride_ == 0) run_.rows.add(system_, state);
    if (static_cast<double>(run_.rows.size()) <= mostOftenLooks) return;
    run_.rows.thin();
    stride_ *= 2;
  }

  const ModelSystem& system_;
  const std::vector<double>& times_;
  bool dense_;
  const PilotLimits& limits_;
  PilotRun& run_;
  std::size_t next_ = 0;
  long long steps_ = 0, stride_ = 1;
};

}  // namespace

bool PilotRun::touches() const {
  return std::ranges::any_of(firstTouch, [](double t) { return std::isfinite(t); });
}

Looks::Looks(const Scene& scene) : duration_(scene.duration), dense_(scene.outputInterval > 0.0) {
  const double numbers = 6.0 * static_cast<double>(std::max<std::size_t>(1, scene.model.nodes.size()));
  if (dense_) {
    const auto outputs = static_cast<long long>(std::floor(scene.duration / scene.outputInterval * (1.0 + 1e-12)));
    const double room = std::clamp(mostNumbers / numbers, 24.0, static_cast<double>(sampleCount));
    const long long stride = 1 + outputs / static_cast<long long>(room);
    for (long long i = stride; i <= outputs; i += stride)
      times_.push_back(scene.outputInterval * static_cast<double>(i));
    if (times_.empty() || times_.back() < duration_ * (1.0 - 1e-9)) times_.push_back(duration_);
    times_.back() = duration_;
    return;
  }
  long long samples = sampleCount;
  while (samples > 24 && static_cast<double>(samples) * numbers > mostNumbers) samples /= 2;
  for (long long i = 1; i <= samples; ++i) {
    times_.push_back(duration_ * static_cast<double>(i) / static_cast<double>(samples));
  }
  times_.back() = duration_;
}

long long Looks::stepsOf(double h) const {
  // A step that divides the duration but for rounding is not cut into one more.
  const double exact = std::ceil(duration_ / h * (1.0 - 1e-9));
  if (!(exact < 1e15)) throw std::invalid_argument("a step that is a billionth of the run, or shorter");
  const long long steps = std::max(1LL, static_cast<long long>(exact));
  if (dense_) return steps;
  // Ends of steps have to fall on these times, at a step that is hardly shorter.
  constexpr long long few[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 24};
  if (steps <= few[std::size(few) - 1]) return *std::ranges::lower_bound(few, steps);
  long long multiple = 2;
  for (const long long m : {3, 6, 12, 24, 48, 120, 240}) {
    if (10 * m <= steps) multiple = m;
  }
  return (steps + multiple - 1) / multiple * multiple;
}

std::vector<std::size_t> Looks::ofSteps(long long steps) const {
  if (dense_) return some(count());
  const auto samples = static_cast<long long>(count());
  return some(static_cast<std::size_t>(std::gcd(steps, samples)));
}

std::vector<std::size_t> Looks::some(std::size_t most) const {
  const std::size_t all = count();
  std::vector<std::size_t> chosen;
  if (!dense_) {
    while (all % most != 0) --most;
    for (std::size_t i = 1; i <= most; ++i) chosen.push_back(i * (all / most) - 1);
    return chosen;
  }
  const std::size_t stride = 1 + (all - 1) / most;
  for (std::size_t i = all; i > 0; i = i > stride ? i - stride : 0) chosen.push_back(i - 1);
  std::ranges::reverse(chosen);
  return chosen;
}

StepOptions Pilots::optionsOf(const Setting& setting) const {
  const RunOptions whole = lab::optionsOf(withSetting(scene_, setting));
  const StepOptions& stepping = whole;
  StepOptions options = stepping;
  if (setting.fixed && !looks_.isDense()) {
    options.h = scene_.duration / static_cast<double>(looks_.stepsOf(setting.value));
  }
  return options;
}

PilotRun Pilots::run(const Setting& setting, const PilotLimits& limits) const {
  PilotRun run;
  run.setting = setting;
  StepOptions options = optionsOf(setting);
  if (setting.fixed) run.setting.value = options.h;
  std::vector<double> looks;
  const bool meets = setting.fixed && !limits.isReference && !looks_.isDense();
  for (const std::size_t i :
       meets ? looks_.ofSteps(std::llround(scene_.duration / options.h)) : looks_.some(looks_.count())) {
    looks.push_back(looks_.time(i));
  }
  // Only a reference and fixed steps, which end there anyhow, are made to meet these times.
  if (limits.isReference || meets) options.outputTimes = looks;
  if (limits.looksOften) looks = looks_.isDense() ? outputTimes() : std::vector<double>{};
  const double begun = bench::processorTime();
  try {
    follow(options, looks, limits, run);
  } catch (const std::invalid_argument& problem) {
    run.failure = problem.what();
  }
  run.seconds = bench::processorTime() - begun;
  return run;
}

std::vector<double> Pilots::outputTimes() const {
  const double outputs = std::floor(scene_.duration / scene_.outputInterval * (1.0 + 1e-12));
  const double stride = std::ceil(std::max(1.0, outputs / mostOftenLooks));
  std::vector<double> times;
  for (double i = stride; i * scene_.outputInterval < scene_.duration; i += stride)
    times.push_back(i * scene_.outputInterval);
  times.push_back(scene_.duration);
  return times;
}

void Pilots::follow(const StepOptions& options, const std::vector<double>& looks, const PilotLimits& limits,
                    PilotRun& run) const {
  const std::unique_ptr<Integrator> method = makeMethod(run.setting.method);
  const State start = limits.start != nullptr ? *limits.start : system_.initialState();
  Simulation simulation(system_, *method, start, options);
  MotionFrame frame(system_, start);
  GapWatch gaps(system_, watched_, run);
  RowRecorder recorder(system_, looks, looks_.isDense() && !limits.isReference, limits, run);
  const bool watches = limits.isReference || limits.watchesGaps;
  if (watches) gaps.see(simulation.state(), 0.0);
  run.startGap = run.leastGap;
  if (limits.isReference) run.states.push_back(simulation.state());
  Deadline deadline(limits);
  for (Advance advance = simulation.advance(); advance.goesOn(); advance = simulation.advance()) {
    if (limits.isReference) {
      const ErrorScale size = frame.sizeAt(system_, simulation.state());
      run.motion.include({size.position, size.velocity});
    }
    if (watches) gaps.see(simulation.state(), advance.length);
    recorder.see(simulation, advance);
    run.outOfTime = deadline.passed();
    if (run.outOfTime) break;
  }
  run.reached = simulation.time();
  run.steps = simulation.work().steps + simulation.work().rejectedSteps;
  run.evaluations = simulation.work().forceEvaluations;
  if (!simulation.finished()) {
    run.failure = run.outOfTime ? "given up for its time" : simulation.stop().message;
  } else if (!recorder.hasAll()) {
    run.failure = "the run ended before its last output";
  }
}

State Pilots::advance(const Setting& setting, const State& from, double t) const {
  StepOptions options = optionsOf(setting);
  options.duration = t - from.t;
  options.h = setting.fixed ? std::min(options.h, options.duration) : options.duration;
  const std::unique_ptr<Integrator> method = makeMethod(setting.method);
  Simulation simulation(system_, *method, from, options);
  while (simulation.advance().goesOn()) {
  }
  return simulation.state();
}

void Pilots::runBare(const Setting& setting) const {
  const std::unique_ptr<Integrator> method = makeMethod(setting.method);
  Simulation simulation(system_, *method, system_.initialState(), optionsOf(setting));
  if (looks_.isDense()) {
    const double interval = scene_.outputInterval;
    for (long long i = 1; simulation.advanceTo(std::min(scene_.duration, interval * static_cast<double>(i))); ++i) {
      const double t = interval * static_cast<double>(i);
      if (t >= scene_.duration) break;
      simulation.at(t);
    }
  } else {
    while (simulation.advance().goesOn()) {
    }
  }
}

double Pilots::bareSeconds(const Setting& setting) const {
  return bench::secondsOf([&] { runBare(setting); }, bench::processorTime, 1e-3);
}

double Pilots::secondsOfStep(const std::string& id, double h) const {
  StepOptions options = optionsOf({id, true, h});
  options.h = h;
  const std::unique_ptr<Integrator> method = makeMethod(id);
  constexpr double enough = 3e-4;  // [s]
  double best = never, spent = 0.0;
  // The first step of a run prepares what the others use.
  for (int round = 0; round < 50 && spent < enough; ++round) {
    Simulation simulation(system_, *method, system_.initialState(), options);
    double begun = bench::processorTime();
    if (!simulation.advance().goesOn()) return never;
    double taken = bench::processorTime() - begun;
    spent += taken;
    if (taken > 0.02) return std::min(best, taken);
    begun = bench::processorTime();
    int steps = 0;
    while (steps < 8 && simulation.advance().goesOn()) ++steps;
    taken = bench::processorTime() - begun;
    spent += taken;
    if (steps > 0) best = std::min(best, taken / steps);
  }
  return best;
}

std::string refusalOf(const ModelSystem& system, const std::string& id) {
  try {
    const std::unique_ptr<Integrator> method = makeMethod(id);
    checkRodsAreHeld(system, method->info());
    method->prepare(system, {});
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return {};
}

}  // namespace muelle::lab

#include "engine/control/step_planner.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

std::vector<double> declaredTimes(const DynamicalSystem& system, double from, double to) {
  std::vector<double> times;
  if (system.switching() != nullptr) system.switching()->declaredTimes(from, to, times);
  return times;
}

StepPlanner::StepPlanner(const DynamicalSystem& system, const StepOptions& options, bool adaptive, bool stopsAtJumps,
                         double start)
    : system_(system),
      options_(options),
      adaptive_(adaptive),
      stopsAtJumps_(stopsAtJumps),
      end_(start + options.duration),
      stops_(stopsFrom(start)),
      grid_(start, options.h) {}

StopTimes StepPlanner::stopsFrom(double t) const {
  return {t, end_, stopsAtJumps_ ? declaredTimes(system_, t, end_) : std::vector<double>{}, options_.outputTimes};
}

void StepPlanner::chooseFirstStep(const State& from, int order, const ErrorScale& scale, Work& work) {
  const double h = options_.h > 0.0
                       ? options_.h
                       : firstStep(system_, from, order, options_.tolerance.relative, scale, options_.duration, work);
  controller_.emplace(order, h, options_.largestStep);
}

void StepPlanner::restart(double t) {
  stops_ = stopsFrom(t);
  piece_ = std::numeric_limits<double>::infinity();
  failures_ = 0;
}

double StepPlanner::shortest(double t) const {
  return std::max(2.0 * timeRounding(t, end_), 1e-15 * options_.duration);
}

PlannedStep StepPlanner::planByError(double t) const {
  // Lest a vibration looks like none.
  const double h = std::min(controller_->h(), system_.shortestPeriod(t) / options_.stepsAPeriod);
  const double rest = stops_.next().t - t;
  if (rest <= h * (1.0 + 1e-6)) return {stops_.next().t, rest, true, false};
  // Two equal steps to the stop instead of a long one and a sliver.
  const double end = t + (rest < 2.0 * h ? 0.5 * rest : h);
  // The length is the difference of the two times, which is exact, so that the time never drifts from the sum of steps.
  return {end, end - t, false, false};
}

PlannedStep StepPlanner::plan(double t) const {
  PlannedStep step = adaptive_ ? planByError(t) : grid_.plan(t, stops_.next());
  // Pieces that end by rounding short of the grid would leave a sliver of a step.
  if (step.length > piece_ * (1.0 + 1e-6)) shorten(step, t, piece_);
  return step;
}

PlannedStep StepPlanner::planClosedForm(double t, double longest) const {
  const double rest = stops_.next().t - t, most = std::min(longest, options_.largestStep);
  if (rest <= most) return {stops_.next().t, rest, true, false};
  return {t + most, (t + most) - t, false, false};
}

void StepPlanner::shorten(PlannedStep& step, double t, double length) {
  step.t = t + length;
  step.length = step.t - t;
  step.reachesStop = step.reachesGrid = false;
}

bool StepPlanner::cutAtObstacles(const State& from, PlannedStep& step) const {
  const Switching* switching = system_.switching();
  if (switching == nullptr) return false;
  const double bound = switching->sweptBound(from.t, from.x, from.v, from.z, step.length);
  if (bound >= step.length) return false;
  const double pieces = std::ceil(step.length / std::max(bound, shortest(from.t)));
  shorten(step, from.t, step.length / pieces);
  return true;
}

void StepPlanner::shortenAfterFailure(PlannedStep& step, double t) const {
  shorten(step, t, adaptive_ ? std::min(controller_->h(), step.length) : piece_);
}

void StepPlanner::accept(double length, double error) {
  if (adaptive_) controller_->accept(length, error);
}

void StepPlanner::reject(double length, double error) { controller_->reject(length, error); }

void StepPlanner::fail(double length) {
  ++failures_;
  if (adaptive_) {
    controller_->fail(length);
  } else {
    piece_ = 0.5 * length;
  }
}

void StepPlanner::moved(const PlannedStep& step) {
  if (!adaptive_) grid_.moved(step.reachesGrid);
  if (adaptive_ || step.reachesGrid) failures_ = 0;
  // After a failure the pieces grow again, at most to the grid's step.
  if (piece_ < options_.h) piece_ *= 2.0;
}

StopTimes::Stop StepPlanner::reachStop() {
  const StopTimes::Stop stop = stops_.next();
  stops_.advance();
  return stop;
}

}  // namespace muelle::engine

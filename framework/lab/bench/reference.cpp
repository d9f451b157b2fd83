#include "lab/bench/reference.h"

#include "base/file.h"
#include "engine/control/motion_frame.h"
#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"
#include "lab/bench/engine_contestant.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>
#include <utility>

namespace muelle::bench {

using namespace engine;

namespace {

constexpr const char* exactMethod = "dop853";

/// Where stability bounds the steps their errors are far below any tolerance; a tighter one asks for less than rounding
/// in a cloth that has hardly begun to move.
double exactTolerance(const BenchScene& scene) {
  return scene.kind == SceneKind::Small || scene.kind == SceneKind::Bounce ? 1e-13 : 1e-11;
}

StepOptions exactOptions(const BenchScene& scene, double duration, double tolerance) {
  StepOptions options;
  options.duration = duration;
  options.tolerance.relative = tolerance;
  options.locateEvents = scene.locateEvents;
  return options;
}

std::runtime_error failureOf(const BenchScene& scene, const Simulation& simulation) {
  return std::runtime_error(fmt::format("{}: the reference fails: {}", scene.name, simulation.stop().message));
}

void append(std::string& bytes, const std::vector<double>& values) {
  const std::size_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(double));
}

/// Takes an array off the front; false where it is cut off.
bool take(std::string_view& bytes, std::vector<double>& values) {
  std::size_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (bytes.size() / sizeof(double) < count) return false;
  values.resize(count);
  std::memcpy(values.data(), bytes.data(), count * sizeof(double));
  bytes.remove_prefix(count * sizeof(double));
  return true;
}

}  // namespace

double largestNodeDistance(const std::vector<double>& a, const std::vector<double>& b, int dimension) {
  const auto columns = static_cast<std::size_t>(dimension);
  double largest = 0.0;
  for (std::size_t node = 0; node < a.size(); node += columns) {
    double squares = 0.0;
    for (std::size_t c = node; c < node + columns; ++c) squares += (a[c] - b[c]) * (a[c] - b[c]);
    if (!(squares <= largest)) largest = squares;  // a NaN stays
  }
  return std::sqrt(largest);
}

Reference::Reference(const BenchScene& scene, const ModelSystem& system, const std::filesystem::path& file,
                     const std::string& stamp)
    : scene_(scene), system_(system) {
  if (!read(file, stamp)) {
    compute();
    write(file, stamp);
  }
  if (motion_.position == 0.0 || motion_.velocity == 0.0) throw std::runtime_error(scene.name + ": nothing moves");
}

void Reference::compute() { states_ = statesFrom(system_.initialState(), exactTolerance(scene_), &motion_); }

std::vector<State> Reference::statesFrom(State start, double tolerance, PathError* motion) const {
  MotionFrame frame(system_, start);
  std::vector<State> states = {start};
  const std::unique_ptr<Integrator> method = makeMethod(exactMethod);
  StepOptions options = exactOptions(scene_, scene_.duration, tolerance);
  for (int j = 1; j < scene_.samples; ++j) options.outputTimes.push_back(scene_.duration * j / scene_.samples);
  Simulation simulation(system_, *method, std::move(start), options);
  for (Advance advance = simulation.advance(); advance.goesOn(); advance = simulation.advance()) {
    if (advance.atOutput) states.push_back(simulation.state());
    if (motion == nullptr) continue;
    // At the samples alone a motion whose period they share would look like none.
    const ErrorScale size = frame.sizeAt(system_, simulation.state());
    motion->position = std::max(motion->position, size.position);
    motion->velocity = std::max(motion->velocity, size.velocity);
  }
  if (!simulation.finished()) throw failureOf(scene_, simulation);
  if (std::ssize(states) != scene_.samples + 1) throw std::logic_error(scene_.name + ": the reference lacks a time");
  return states;
}

State Reference::stateAt(double t) const {
  const auto later = std::upper_bound(states_.begin(), states_.end(), t + 1e-12 * scene_.duration,
                                      [](double time, const State& state) { return time < state.t; });
  const State& before = *(later == states_.begin() ? later : later - 1);
  if (std::abs(t - before.t) <= 1e-12 * scene_.duration) return before;
  const std::unique_ptr<Integrator> method = makeMethod(exactMethod);
  StepOptions options = exactOptions(scene_, t - before.t, exactTolerance(scene_));
  options.h = t - before.t;  // mostly one step is enough
  Simulation simulation(system_, *method, before, options);
  while (simulation.advance().goesOn()) {
  }
  if (!simulation.finished()) throw failureOf(scene_, simulation);
  return simulation.state();
}

PathError Reference::errorOf(const Path& path) const {
  if (path.points().empty()) throw std::runtime_error(scene_.name + ": a run has shown no state");
  PathError error;
  for (const PathPoint& point : path.points()) {
    const PathPoint exact = pointOf(system_, stateAt(point.t));
    const double x = largestNodeDistance(point.x, exact.x, system_.dimension()) / motion_.position;
    const double v = largestNodeDistance(point.v, exact.v, system_.dimension()) / motion_.velocity;
    if (!(x <= error.position)) error.position = x;
    if (!(v <= error.velocity)) error.velocity = v;
  }
  return error;
}

void Reference::judgeBy(const std::string& arbiter, const PathError& error) {
  arbiter_ = arbiter;
  doubt_ = error;
}

double Reference::amplification() const {
  std::mt19937 dice(9);
  State start = states_.front();
  const double offset = 1e-7 * motion_.position;
  // Lanes that are no unknowns stay: a held node that moved would be another scene.
  const std::span<const double> free = system_.inverseMass();
  for (std::size_t lane = 0; lane < start.x.size(); ++lane) {
    if (free[lane] > 0.0) start.x[lane] += offset * (static_cast<double>(dice() % 2001) / 1000.0 - 1.0);
  }
  start.z.clear();
  const PathPoint begin = pointOf(system_, states_.front());
  const double disturbed = largestNodeDistance(pointOf(system_, start).x, begin.x, system_.dimension());
  const std::vector<State> other = statesFrom(std::move(start), 1e-11, nullptr);
  double largest = 0.0;
  for (std::size_t j = 0; j < states_.size(); ++j) {
    largest = std::max(largest, largestNodeDistance(pointOf(system_, other[j]).x, pointOf(system_, states_[j]).x,
                                                    system_.dimension()));
  }
  return largest / disturbed;
}

bool Reference::read(const std::filesystem::path& file, const std::string& stamp) {
  const std::optional<std::string> content = tryReadFile(file);
  if (!content || !content->starts_with(stamp + "\n")) return false;
  std::string_view bytes = std::string_view(*content).substr(stamp.size() + 1);
  std::vector<State> states;
  std::vector<double> time, motion;
  if (!take(bytes, motion) || motion.size() != 2) return false;
  while (!bytes.empty()) {
    State state;
    if (!take(bytes, time) || !take(bytes, state.x) || !take(bytes, state.v) || !take(bytes, state.z)) return false;
    state.t = time.at(0);
    states.push_back(std::move(state));
  }
  if (std::ssize(states) != scene_.samples + 1) return false;
  states_ = std::move(states);
  motion_ = {motion[0], motion[1]};
  return true;
}

void Reference::write(const std::filesystem::path& file, const std::string& stamp) const {
  std::string bytes = stamp + "\n";
  append(bytes, {motion_.position, motion_.velocity});
  for (const State& state : states_) {
    append(bytes, {state.t});
    append(bytes, state.x);
    append(bytes, state.v);
    append(bytes, state.z);
  }
  writeFile(file, bytes);
}

}  // namespace muelle::bench

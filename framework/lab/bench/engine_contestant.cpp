#include "lab/bench/engine_contestant.h"

#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"

#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace muelle::bench {

using namespace engine;

namespace {

class EngineContestant : public Contestant {
 public:
  EngineContestant(const BenchScene& scene, const ModelSystem& system, std::string id, bool fixed)
      : scene_(scene), system_(system), id_(std::move(id)), fixed_(fixed) {}

  Row row() const override { return Row::Ours; }
  std::string library() const override { return "muelle"; }
  std::string method() const override { return methodInfo(id_).adaptive && fixed_ ? id_ + "_fixed" : id_; }
  bool takesTolerance() const override { return !fixed_; }
  bool locatesEvents() const override { return scene_.locateEvents && !scene_.model.obstacles.empty(); }

  RunCost run(double setting, Path* path) override {
    const std::unique_ptr<Integrator> integrator = makeMethod(id_);
    Simulation simulation(system_, *integrator, system_.initialState(), optionsFor(setting));
    while (simulation.advance().goesOn()) {
      if (path != nullptr && path->wants(simulation.time())) path->see(pointOf(system_, simulation.state()));
    }
    const Work work = simulation.work();
    RunCost cost{work.forceEvaluations, work.jacobians, work.solves, {}};
    if (!simulation.finished()) cost.failure = simulation.stop().message;
    return cost;
  }

 private:
  StepOptions optionsFor(double setting) const {
    StepOptions options;
    options.duration = scene_.duration;
    options.locateEvents = scene_.locateEvents;
    options.fixedStep = fixed_;
    // A tolerance below rounding makes steps without end.
    options.mostForceEvaluations = unknownsOf(scene_.model) < 100 ? 100'000'000 : 2'000'000;
    if (fixed_) {
      options.h = scene_.duration / static_cast<double>(scene_.stepsOf(setting));
    } else {
      options.tolerance.relative = setting;
    }
    return options;
  }

  const BenchScene& scene_;
  const ModelSystem& system_;
  std::string id_;
  bool fixed_;
};

/// Why the method cannot run the system; empty when it can.
std::string refusal(const ModelSystem& system, const std::string& id) {
  try {
    makeMethod(id)->prepare(system, {});
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return {};
}

}  // namespace

PathPoint pointOf(const ModelSystem& system, const State& state) {
  const Model& model = system.model();
  const std::array<int, 3> axes =
      model.dimension == 2 ? std::array<int, 3>{model.plane[0], model.plane[1], -1} : std::array<int, 3>{0, 1, 2};
  const auto dimension = static_cast<std::size_t>(model.dimension);
  PathPoint point;
  point.t = state.t;
  point.x.resize(model.nodes.size() * dimension);
  point.v.resize(model.nodes.size() * dimension);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Vec3 x = system.position(state, static_cast<int>(i)), v = system.velocity(state, static_cast<int>(i));
    for (std::size_t c = 0; c < dimension; ++c) {
      point.x[i * dimension + c] = x[axes[c]];
      point.v[i * dimension + c] = v[axes[c]];
    }
  }
  return point;
}

Contestants engineContestants(const BenchScene& scene, const ModelSystem& system, std::vector<std::string>& left) {
  Contestants all;
  for (const std::string& id : methodIds()) {
    const std::string reason = refusal(system, id);
    if (!reason.empty()) {
      left.push_back(fmt::format("{}: {}", id, reason));
      continue;
    }
    const bool adaptive = methodInfo(id).adaptive;
    all.push_back(std::make_unique<EngineContestant>(scene, system, id, !adaptive));
    if (adaptive && id.starts_with("nystrom")) {
      all.push_back(std::make_unique<EngineContestant>(scene, system, id, true));
    }
  }
  return all;
}

}  // namespace muelle::bench

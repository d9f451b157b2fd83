#include "steps.h"

#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"

#include <cmath>
#include <stdexcept>

namespace muelle::benchmarks {

namespace {

constexpr double nodeMass = 1e-3;  // [kg]
constexpr double length = 1e-6;    // [s] of a step: h omega = 0.02
constexpr double g = 9.81;         // [m/s^2]

bool isHeld(const Cloth& cloth, std::size_t user) {
  // By where it is: the cloth may be shuffled. Corners lie within a tenth of a mesh of (0, 0) and (0, 1 - mesh).
  const double* x = cloth.x.data() + 3 * user;
  const double mesh = 1.0 / std::sqrt(static_cast<double>(cloth.nodes));
  return x[0] < 0.5 * mesh && (x[1] < 0.5 * mesh || x[1] > 1.0 - 1.5 * mesh);
}

}  // namespace

PlainSteps::PlainSteps(const Cloth& cloth, bool damped, const PlainLoops& loops)
    : loops_(loops), damped_(damped), x_(cloth.x), v_(cloth.v), f_(cloth.x.size()) {
  for (const auto& s : cloth.springs) {
    if (damped_) {
      dampedSprings_.push_back({s.a, s.b, s.k, s.L0, s.dProjected});
    } else {
      springs_.push_back({s.a, s.b, s.k, s.L0});
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(cloth.nodes); ++i) {
    held_.push_back(isHeld(cloth, i));
    if (held_.back()) v_[3 * i] = v_[3 * i + 1] = v_[3 * i + 2] = 0.0;
  }
}

void PlainSteps::step() {
  if (damped_) {
    loops_.damped(dampedSprings_.data(), dampedSprings_.size(), x_.data(), v_.data(), f_.data(), f_.size());
  } else {
    loops_.undamped(springs_.data(), springs_.size(), x_.data(), f_.data(), f_.size());
  }
  constexpr double kick = length / nodeMass;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (held_[i]) continue;
    f_[3 * i + 2] -= nodeMass * g;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      v_[c] += kick * f_[c];
      x_[c] += length * v_[c];
    }
  }
}

struct EngineSteps::Run {
  std::unique_ptr<engine::ModelSystem> system;
  std::unique_ptr<engine::Integrator> method = engine::makeMethod("symplectic_euler");
  std::unique_ptr<engine::Simulation> simulation;
};

EngineSteps::EngineSteps(const Cloth& cloth) : run_(std::make_unique<Run>()) {
  engine::Model model;
  model.gravity = {0.0, 0.0, -g};
  for (std::size_t i = 0; i < static_cast<std::size_t>(cloth.nodes); ++i) {
    engine::ModelNode node;
    node.x = Vec3(cloth.x[3 * i], cloth.x[3 * i + 1], cloth.x[3 * i + 2]);
    node.m = nodeMass;
    node.pinned = isHeld(cloth, i);
    if (!node.pinned) node.v = Vec3(cloth.v[3 * i], cloth.v[3 * i + 1], cloth.v[3 * i + 2]);
    model.nodes.push_back(node);
  }
  for (const auto& s : cloth.springs) {
    model.springs.push_back({.a = s.a, .b = s.b, .k = s.k, .L0 = s.L0, .dProjected = s.dProjected});
  }
  run_->system = engine::build(model);
  engine::StepOptions options;
  options.duration = 1e5;
  options.h = length;
  options.mostSteps = 1'000'000'000'000;
  run_->simulation =
      std::make_unique<engine::Simulation>(*run_->system, *run_->method, run_->system->initialState(), options);
}

EngineSteps::~EngineSteps() = default;

void EngineSteps::step() {
  if (!run_->simulation->advance().goesOn()) throw std::runtime_error(run_->simulation->stop().message);
}

}  // namespace muelle::benchmarks

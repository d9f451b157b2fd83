#include "random_scene.h"

#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "random_model.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

bool canRun(const ModelSystem& system, const std::string& id) {
  const std::unique_ptr<Integrator> method = makeMethod(id);
  if (!system.rods().empty()) return method->info().holdsRods;
  try {
    method->prepare(system, {});
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

std::string randomMethod(Dice& dice, const ModelSystem& system) {
  std::vector<std::string> able;
  for (const std::string& id : methodIds()) {
    if (canRun(system, id)) able.push_back(id);
  }
  return able.at(static_cast<std::size_t>(dice.below(static_cast<int>(able.size()))));
}

}  // namespace

Scene randomScene(std::uint64_t seed) {
  Dice dice(seed);
  Scene scene;
  scene.name = "random";
  scene.title = "drawn";
  scene.model = randomModel(dice);
  scene.locateEvents = !dice.chance(0.1);

  const std::unique_ptr<ModelSystem> system = build(scene.model);
  scene.method = randomMethod(dice, *system);
  double fastest = 3.0;  // [rad/s], of a chain of rods that swings
  State state = system->initialState();
  if (system->switching() != nullptr) system->switching()->close(state);
  for (const Mode& mode : extremeModes(LinearisedSystem(*system, state))) fastest = std::max(fastest, mode.rate());
  double limit = 2.0 / fastest;
  const double own = stability(*system, *makeMethod(scene.method), state).largestStep;
  // Explicit Euler is stable on a mode that is hardly damped up to a step that nobody waits for: there as without
  // limit.
  if (own > 1e-3 * limit) limit = std::min(limit, own);
  if (methodInfo(scene.method).adaptive) scene.tolerance = dice.logarithmic(1e-9, 1e-2);
  scene.step = limit * dice.logarithmic(0.01, 1.0);
  scene.duration = 2.0 * std::numbers::pi / fastest * dice.logarithmic(2.0, 20.0);
  // Rods: the reference is an extrapolation in the step.
  if (!system->rods().empty()) scene.duration = *scene.step * std::ceil(scene.duration / *scene.step);
  return scene;
}

}  // namespace muelle::lab

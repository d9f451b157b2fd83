#include "engine/statics/softer_springs.h"

#include "engine/statics/at_rest.h"

namespace muelle::engine {

namespace {

constexpr double softEA = 1e3;      // over the load, of springs that a search by positions bends well
constexpr int factorisations = 20;  // of each Newton's method on tensions

/// The model with springs no stiffer than EA [N]; nothing where none is stiffer.
std::unique_ptr<ModelSystem> softened(const ModelSystem& system, double EA) {
  Model soft = system.model();
  bool any = false;
  for (ModelSpring& spring : soft.springs) {
    if (!(spring.L0 > 0.0) || !(spring.k * spring.L0 > EA)) continue;
    spring.k = EA / spring.L0;
    any = true;
  }
  return any ? build(soft) : nullptr;
}

/// Newton's method for the springs of `system` from a shape with other ones: with their tensions, which the loads make,
/// or as the lengths say, where springs that do not fit strain each other. Null where neither ends in balance.
std::unique_ptr<TensionForm> stiffened(const ModelSystem& system, const State& start, const TensionForm& from,
                                       Work& work) {
  for (const bool keepTensions : {true, false}) {
    auto form = std::make_unique<TensionForm>(system, start);
    if (keepTensions) {
      form->place(from.positions(), from.tensions());
    } else {
      form->place(from.positions());
    }
    const bool balanced = form->solve(factorisations, false).atRoundOff;
    work += form->work();
    if (balanced) return form;
  }
  return nullptr;
}

}  // namespace

SofterSearch balanceBySofterSprings(const ModelSystem& system, const State& start, const StaticOptions& options) {
  SofterSearch search;
  double EA = softEA * TensionForm(system, start).load();
  std::unique_ptr<ModelSystem> soft = EA > 0.0 ? softened(system, EA) : nullptr;
  if (!soft) return search;
  const StaticResult down = equilibrium(AtRest(*soft, start.t), start, options);
  search.work += down.work;
  search.ranAway = down.ranAway;
  search.furthest = down.state;
  if (!down.balanced || down.ranAway) return search;
  auto form = std::make_unique<TensionForm>(*soft, start);
  form->place(down.state.x);
  form->solve(factorisations, false);
  search.work += form->work();
  search.form = stiffened(system, start, *form, search.work);
  while (!search.form) {
    EA *= 10.0;
    std::unique_ptr<ModelSystem> stiffer = softened(system, EA);
    auto next = stiffened(stiffer ? *stiffer : system, start, *form, search.work);
    if (!next) break;
    if (stiffer) {
      form = std::move(next);
      soft = std::move(stiffer);
    } else {
      search.form = std::move(next);
    }
  }
  return search;
}

}  // namespace muelle::engine

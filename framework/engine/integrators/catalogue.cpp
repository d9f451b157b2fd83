#include "engine/integrators/catalogue.h"

#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "engine/integrators/explicit/methods.h"
#include "engine/integrators/implicit/methods.h"
#include "engine/integrators/position_based/methods.h"

#include <fmt/format.h>
#include <stdexcept>

namespace muelle::engine {

namespace {

using MakeMethod = std::unique_ptr<Method> (*)();

constexpr MakeMethod makers[] = {
    explicitEuler,
    symplecticEuler,
    explicitMidpoint,
    velocityVerlet,
    rattle,
    rungeKutta4,
    dormandPrince5,
    dop853,
    nystrom8,
    nystrom12,
    yoshida4,
    kahanLi8,
    rungeKuttaChebyshev2,
    linearisedBackwardEuler,
    backwardEuler,
    bdf2,
    trBdf2,
    esdirk4,
    newmark,
    implicitMidpoint,
    discreteGradient,
    [] { return xpbd(); },
    [] { return projectiveDynamics(); },
};

/// The facts of each method, in the order of the makers.
const std::vector<MethodInfo>& allInfo() {
  static const std::vector<MethodInfo> infos = [] {
    std::vector<MethodInfo> all;
    for (const MakeMethod make : makers) all.push_back(make()->info());
    return all;
  }();
  return infos;
}

std::size_t indexOf(std::string_view id) {
  const std::vector<std::string>& ids = methodIds();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] == id) return i;
  }
  const std::string word(id);
  throw std::invalid_argument(fmt::format("no method '{}'{}", printableLine(word), suggestion(word, ids)));
}

}  // namespace

const std::vector<std::string>& methodIds() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all;
    for (const MethodInfo& info : allInfo()) all.push_back(info.id);
    return all;
  }();
  return ids;
}

std::unique_ptr<Method> makeMethod(std::string_view id) { return makers[indexOf(id)](); }

const MethodInfo& methodInfo(std::string_view id) { return allInfo()[indexOf(id)]; }

}  // namespace muelle::engine

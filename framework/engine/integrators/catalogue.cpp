#include "engine/integrators/catalogue.h"

#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "engine/integrators/explicit/methods.h"
#include "engine/integrators/implicit/methods.h"
#include "engine/integrators/position_based/methods.h"
#include "engine/integrators/standing.h"

#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

namespace {

using MakeMethod = std::unique_ptr<Integrator> (*)();

constexpr MakeMethod makers[] = {
    explicitEuler,
    symplecticEuler,
    explicitMidpoint,
    velocityVerlet,
    takahashiImada,
    rattle,
    rungeKutta4,
    dormandPrince5,
    dop853,
    rkn64,
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

/// What methods are called elsewhere, in small letters without anything between words, and their ids here.
constexpr std::pair<std::string_view, std::string_view> namesElsewhere[] = {
    {"euler", "explicit_euler"},
    {"forwardeuler", "explicit_euler"},
    {"semiimpliciteuler", "symplectic_euler"},
    {"semiexpliciteuler", "symplectic_euler"},
    {"eulercromer", "symplectic_euler"},
    {"midpoint", "explicit_midpoint"},
    {"rk2", "explicit_midpoint"},
    {"leapfrog", "velocity_verlet"},
    {"verlet", "velocity_verlet"},
    {"stormerverlet", "velocity_verlet"},
    {"stoermerverlet", "velocity_verlet"},
    {"centraldifference", "velocity_verlet"},
    {"centraldifferences", "velocity_verlet"},
    {"ti", "takahashi_imada"},
    {"rowlands", "takahashi_imada"},
    {"rk4", "runge_kutta_4"},
    {"rungekutta", "runge_kutta_4"},
    {"classicalrungekutta", "runge_kutta_4"},
    {"ode45", "dormand_prince_5"},
    {"rk45", "dormand_prince_5"},
    {"rk5", "dormand_prince_5"},
    {"dopri", "dormand_prince_5"},
    {"dopri5", "dormand_prince_5"},
    {"dp5", "dormand_prince_5"},
    {"dormandprince", "dormand_prince_5"},
    {"dopri8", "dop853"},
    {"dopri853", "dop853"},
    {"rk8", "dop853"},
    {"ode78", "dop853"},
    {"rkn6", "rkn64"},
    {"nystrom6", "rkn64"},
    {"rkn86", "nystrom8"},
    {"rkn1210", "nystrom12"},
    {"yoshida", "yoshida4"},
    {"forestruth", "yoshida4"},
    {"kahanli", "kahan_li_8"},
    {"rkc", "rkc2"},
    {"rungekuttachebyshev", "rkc2"},
    {"baraffwitkin", "linearised_backward_euler"},
    {"linearlyimpliciteuler", "linearised_backward_euler"},
    {"linearizedbackwardeuler", "linearised_backward_euler"},
    {"impliciteuler", "backward_euler"},
    {"bdf1", "backward_euler"},
    {"bdf", "bdf2"},
    {"gear2", "bdf2"},
    {"trapezoid", "implicit_midpoint"},
    {"trapezoidal", "implicit_midpoint"},
    {"trapezoidalrule", "implicit_midpoint"},
    {"cranknicolson", "implicit_midpoint"},
    {"cranknicholson", "implicit_midpoint"},
    {"newmarkbeta", "implicit_midpoint"},
    {"averageacceleration", "implicit_midpoint"},
    {"gauss1", "implicit_midpoint"},
    {"gonzalez", "discrete_gradient"},
    {"averagevectorfield", "discrete_gradient"},
    {"pbd", "xpbd"},
    {"positionbaseddynamics", "xpbd"},
    {"pd", "projective_dynamics"},
};

/// "RK-4" is "rk4": small letters and digits alone.
std::string bare(std::string_view word) {
  std::string letters;
  for (const char c : word) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
  }
  return letters;
}

std::size_t indexOf(std::string_view id) {
  const std::vector<std::string>& ids = methodIds();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] == id) return i;
  }
  const std::string word(id);
  throw std::invalid_argument(fmt::format("no method '{}'{}", printableLine(word), methodSuggestion(word)));
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

std::string methodSuggestion(const std::string& word) {
  const std::string letters = bare(word);
  for (const GoneMethod& method : goneMethods()) {
    if (letters == bare(method.id)) {
      return fmt::format("; it has gone (docs/methods.md says why), take '{}'", method.instead);
    }
  }
  for (const std::string& id : methodIds()) {
    if (bare(id) == letters) return fmt::format("; here it is '{}'", id);
  }
  for (const auto& [name, id] : namesElsewhere) {
    if (name == letters) return fmt::format("; here it is '{}'", id);
  }
  return suggestion(word, methodIds());
}

std::unique_ptr<Integrator> makeMethod(std::string_view id) { return makers[indexOf(id)](); }

const MethodInfo& methodInfo(std::string_view id) { return allInfo()[indexOf(id)]; }

}  // namespace muelle::engine

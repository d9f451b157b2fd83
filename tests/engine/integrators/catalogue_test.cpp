#include "engine/integrators/catalogue.h"

#include "base/file.h"
#include "engine/integrators/methods_page.h"
#include "engine/integrators/standing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace muelle::engine {
namespace {

/// What a method can be chosen for.
auto kindOf(const MethodInfo& info) {
  return std::tuple(info.order, info.stability, info.implicit, info.adaptive, info.holdsRods, info.iterative,
                    info.needs.constraints, info.needs.distanceConstraints, info.needs.velocityFreeForce);
}

bool isOnlyOneOfItsKind(std::string_view id) {
  return std::ranges::count_if(methodIds(), [id](const std::string& other) {
           return kindOf(methodInfo(other)) == kindOf(methodInfo(id));
         }) == 1;
}

/// Whether the results of ./muelle bench that are kept have it as the fastest of ours at an error on the scene.
bool winsOn(std::string_view id, std::string_view scene) {
  const std::filesystem::path results = MUELLE_SOURCE "/tests/benchmarks/results";
  for (const auto& machine : std::filesystem::directory_iterator(results)) {
    std::istringstream plane(readFile(machine.path() / "plane.csv"));
    for (std::string line; std::getline(plane, line);) {
      const bool isScene = line.starts_with(std::string(scene) + ",");
      const std::string best = fmt::format(",ours:muelle:{}", id);
      if (isScene && (line.find(best + ",") != std::string::npos || line.find(best + "_fixed,") != std::string::npos)) {
        return true;
      }
    }
  }
  return false;
}

/// Whether the reason is found where it says.
bool holds(const Standing& standing) {
  const std::filesystem::path source = MUELLE_SOURCE;
  switch (standing.because) {
    case Standing::Because::Exercise:
      return std::filesystem::exists(source / "exercises" / standing.where / "exercise.toml");
    case Standing::Because::Figure:
      return readFile(source / "plots" / "figures" / fmt::format("{}.cpp", standing.where))
                 .find(fmt::format("\"{}\"", standing.id)) != std::string::npos;
    case Standing::Because::Plane:
      return winsOn(standing.id, standing.where);
    case Standing::Because::Alone:
      return isOnlyOneOfItsKind(standing.id);
  }
  return false;
}

TEST(Catalogue, EveryMethodHasAnIdOfItsOwnAndSaysWhatItIs) {
  std::set<std::string> ids;
  for (const std::string& id : methodIds()) {
    EXPECT_TRUE(ids.insert(id).second) << id;
    const MethodInfo& info = methodInfo(id);
    EXPECT_EQ(makeMethod(id)->info().id, id);
    for (const std::string& text : {info.name, info.formula, info.source, info.remark})
      EXPECT_FALSE(text.empty()) << id;
    EXPECT_GE(info.order, 1) << id;
    EXPECT_EQ(info.implicit || info.iterative, info.stages == 0) << id;
  }
  EXPECT_GE(ids.size(), 20U);
}

TEST(Catalogue, AMistypedMethodGetsTheNearestName) {
  try {
    makeMethod("velocity_verlt");
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("velocity_verlet"), std::string::npos) << error.what();
  }
}

TEST(Catalogue, NamesFromElsewhereLeadToTheMethodThatIsMeant) {
  // As textbooks and libraries call them (scipy, MATLAB, Hairer's codes, finite element programs).
  const std::pair<const char*, const char*> meant[] = {{"rk4", "runge_kutta_4"},
                                                       {"RK-4", "runge_kutta_4"},
                                                       {"euler", "explicit_euler"},
                                                       {"Forward Euler", "explicit_euler"},
                                                       {"leapfrog", "velocity_verlet"},
                                                       {"verlet", "velocity_verlet"},
                                                       {"stormer-verlet", "velocity_verlet"},
                                                       {"semi_implicit_euler", "symplectic_euler"},
                                                       {"implicit_euler", "backward_euler"},
                                                       {"trapezoid", "implicit_midpoint"},
                                                       {"crank_nicolson", "implicit_midpoint"},
                                                       {"newmark_beta", "implicit_midpoint"},
                                                       {"ode45", "dormand_prince_5"},
                                                       {"rk45", "dormand_prince_5"},
                                                       {"dopri5", "dormand_prince_5"},
                                                       {"DOPRI853", "dop853"},
                                                       {"VelocityVerlet", "velocity_verlet"},
                                                       {"baraff-witkin", "linearised_backward_euler"}};
  for (const auto& [word, id] : meant) {
    EXPECT_EQ(methodSuggestion(word), std::string("; here it is '") + id + "'") << word;
    EXPECT_THROW(makeMethod(word), std::invalid_argument) << word;
  }
  EXPECT_EQ(methodSuggestion("dop85"), "; did you mean 'dop853'?");
  EXPECT_NE(methodSuggestion("adams").find("; there are explicit_euler"), std::string::npos);
}

TEST(Catalogue, EveryMethodHasAReasonToStandInIt) {
  ASSERT_EQ(standings().size(), methodIds().size());
  for (std::size_t i = 0; i < standings().size(); ++i) {
    const Standing& standing = standings()[i];
    EXPECT_EQ(standing.id, methodIds()[i]) << "the reasons are in the order of the catalogue";
    EXPECT_TRUE(holds(standing)) << standing.id << " is not found in " << standing.where;
  }
}

TEST(Catalogue, SaysOfAMethodThatHasGoneWhatToTake) {
  for (const GoneMethod& method : goneMethods()) {
    const std::string id(method.id);
    EXPECT_EQ(std::ranges::count(methodIds(), id), 0) << id;
    EXPECT_EQ(std::ranges::count(methodIds(), std::string(method.instead)), 1) << id;
    EXPECT_NE(methodSuggestion(id).find("it has gone"), std::string::npos);
    EXPECT_THROW(makeMethod(id), std::invalid_argument);
  }
}

TEST(Catalogue, ThePageOfTheMethodsIsUpToDate) {
  EXPECT_EQ(readFile(MUELLE_SOURCE "/docs/methods.md"), methodsPage())
      << "write it again: build/bin/muelle-methods-page docs/methods.md";
}

}  // namespace
}  // namespace muelle::engine

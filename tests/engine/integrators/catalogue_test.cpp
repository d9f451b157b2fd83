#include "engine/integrators/catalogue.h"

#include "base/file.h"
#include "engine/integrators/methods_page.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace muelle::engine {
namespace {

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
                                                       {"trapezoid", "newmark"},
                                                       {"crank_nicolson", "newmark"},
                                                       {"newmark_beta", "newmark"},
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

TEST(Catalogue, ThePageOfTheMethodsIsUpToDate) {
  EXPECT_EQ(readFile(MUELLE_SOURCE "/docs/methods.md"), methodsPage())
      << "write it again: build/bin/muelle-methods-page docs/methods.md";
}

}  // namespace
}  // namespace muelle::engine

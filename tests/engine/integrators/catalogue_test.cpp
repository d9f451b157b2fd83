#include "engine/integrators/catalogue.h"

#include "base/file.h"
#include "engine/integrators/methods_page.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

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

TEST(Catalogue, ThePageOfTheMethodsIsUpToDate) {
  EXPECT_EQ(readFile(MUELLE_SOURCE "/docs/methods.md"), methodsPage())
      << "write it again: build/bin/muelle-methods-page docs/methods.md";
}

}  // namespace
}  // namespace muelle::engine

#include "course/contract.h"

#include <gtest/gtest.h>
#include <stdexcept>

namespace muelle {
namespace {

constexpr const char* contract = R"(
struct Attachment { double x; double k; double L0; };
MUELLE_STRUCT(Attachment, x, k, L0)
/// pull(a, b) in a comment is none.
Vec3 pull(const Vec3& x, double m,
          const std::vector<Attachment>& springs, const std::function<double(double, int)>& f);
double none();
MUELLE_RANGE(k, 1e-3, 1e9)
MUELLE_RANGE(springs, 0, 40)
MUELLE_FUNCTIONS(pull, none)
)";

TEST(Contract, NamesTheParameters) {
  const std::vector<Parameter> parameters = parametersOf(contract, "pull");
  ASSERT_EQ(parameters.size(), 4U);
  EXPECT_EQ(parameters[0].name, "x");
  EXPECT_EQ(parameters[2].name, "springs");
  EXPECT_EQ(parameters[2].fields, (std::vector<std::string>{"x", "k", "L0"}));
  EXPECT_EQ(parameters[3].name, "f");
  EXPECT_TRUE(parametersOf(contract, "none").empty());
  EXPECT_TRUE(parametersOf(contract, "push").empty());
}

TEST(Contract, StatesRanges) {
  const std::vector<Range> ranges = rangesOf(contract);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].name, "k");
  EXPECT_EQ(ranges[0].least, 1e-3);
  EXPECT_EQ(ranges[0].most, 1e9);
  EXPECT_EQ(ranges[1].most, 40);
  EXPECT_THROW(rangesOf("MUELLE_RANGE(k, few, 3)"), std::runtime_error);
}

TEST(Contract, NamesItsFunctions) { EXPECT_EQ(functionsOf(contract), (std::vector<std::string>{"pull", "none"})); }

}  // namespace
}  // namespace muelle

#include "harness/probes.h"
#include "harness/function_system.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

const FunctionSystem twoNodes({2, 2, 2, 3, 3, 3}, [](double, In, In, Out) {});
const State state{0.0, {1, 2, 3, -1, 0, 2}, {4, 5, 6, 1, -1, 2}, {}};

TEST(Probes, MeasureTheKineticEnergy) {
  // 2 (16 + 25 + 36) / 2 + 3 (1 + 1 + 4) / 2
  EXPECT_DOUBLE_EQ(kineticEnergy(twoNodes).measure(state), 77 + 9);
  EXPECT_EQ(kineticEnergy(twoNodes).unit, "J");
}

TEST(Probes, MeasureTheMomenta) {
  const Vec3 p = 2 * Vec3(4, 5, 6) + 3 * Vec3(1, -1, 2);
  // By hand: (1,2,3) x (4,5,6) = (-3,6,-3); (-1,0,2) x (1,-1,2) = (2,4,1).
  const Vec3 J = 2 * Vec3(-3, 6, -3) + 3 * Vec3(2, 4, 1);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_DOUBLE_EQ(linearMomentum(twoNodes, axis).measure(state), p[axis]);
    EXPECT_DOUBLE_EQ(angularMomentum(twoNodes, axis).measure(state), J[axis]);
  }
  EXPECT_EQ(linearMomentum(twoNodes, 1).name, "linear momentum y");
  EXPECT_EQ(angularMomentum(twoNodes, 2).name, "angular momentum z");
}

TEST(Probes, RefuseSystemsAndAxesWithoutMeaning) {
  const FunctionSystem line({1.0, 1.0}, [](double, In, In, Out) {});
  EXPECT_THROW(linearMomentum(line, 0), std::invalid_argument);
  EXPECT_THROW(angularMomentum(twoNodes, 3), std::invalid_argument);
  EXPECT_THROW(linearMomentum(twoNodes, -1), std::invalid_argument);
}

TEST(Probes, AddUp) {
  const Probe ten{"ten", "J", [](const State&) { return 10.0; }};
  const Probe total = sum("total energy", {kineticEnergy(twoNodes), ten, ten});
  EXPECT_DOUBLE_EQ(total.measure(state), 106);
  EXPECT_EQ(total.name, "total energy");
  EXPECT_EQ(total.unit, "J");
  EXPECT_THROW(sum("nonsense", {ten, linearMomentum(twoNodes, 0)}), std::invalid_argument);
  EXPECT_THROW(sum("nothing", {}), std::invalid_argument);
}

}  // namespace
}  // namespace muelle

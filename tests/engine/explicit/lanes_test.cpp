/// \file
/// A system whose arrays hold more than its unknowns: held and moved nodes and padding, as a model lays them out.

#include "engine/integrators/explicit/methods.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>

namespace muelle::engine {
namespace {

using Make = std::unique_ptr<Integrator> (*)();

/// A mass on a spring from a support that shakes, s(t) = 0.1 sin(3 t), and another spring to a wall: one unknown.
class Shaken : public DynamicalSystem {
 public:
  int size() const override { return 1; }
  std::span<const double> mass() const override { return mass_; }
  bool forceUsesVelocity() const override { return false; }
  void force(double t, In x, In, In, Out f) const override {
    f[0] = -6.0 * std::sin(x[0] - 0.1 * std::sin(3.0 * t)) - 2.0 * x[0];
  }

 private:
  std::array<double, 1> mass_{2.0};
};

/// The same in lanes: wall, support, mass, padding and one more of it. The force reads the support's lane.
class InLanes : public DynamicalSystem {
 public:
  int size() const override { return 1; }
  int storage() const override { return 5; }
  std::span<const int> lanes() const override { return lanes_; }
  std::span<const double> mass() const override { return mass_; }
  bool forceUsesVelocity() const override { return false; }
  void force(double t, In x, In v, In, Out f) const override {
    EXPECT_EQ(x[0], 0.5);
    EXPECT_DOUBLE_EQ(x[1], 0.1 * std::sin(3.0 * t));
    EXPECT_DOUBLE_EQ(v[1], 0.3 * std::cos(3.0 * t));
    EXPECT_EQ(x[3], 0.0);
    EXPECT_EQ(v[0], 0.0);
    f[0] = 7.0;  // on what is held: no acceleration comes of it
    f[1] = -3.0;
    f[2] = -6.0 * std::sin(x[2] - x[1]) - 2.0 * (x[2] - x[0] + 0.5);
    f[3] = f[4] = 0.0;
  }
  void place(double t, In, Out x, Out v) const override {
    x[1] = 0.1 * std::sin(3.0 * t);
    v[1] = 0.3 * std::cos(3.0 * t);
  }
  std::string unknownName(int i) const override { return i == 0 ? "the mass" : "nothing"; }

 private:
  std::array<int, 1> lanes_{2};
  std::array<double, 5> mass_{0.0, 0.0, 2.0, 0.0, 0.0};
};

class Lanes : public ::testing::TestWithParam<Make> {};
INSTANTIATE_TEST_SUITE_P(Explicit, Lanes,
                         ::testing::Values(explicitEuler, symplecticEuler, explicitMidpoint, velocityVerlet,
                                           takahashiImada, rattle, rungeKutta4, dormandPrince5, dop853, rkn64, nystrom8,
                                           nystrom12, yoshida4, kahanLi8, rungeKuttaChebyshev2),
                         [](const auto& instance) { return instance.param()->info().id; });

// The motion is the same number for number where no sum goes over lanes, and the other lanes are where they belong.
// (RKC2 asks its spectral radius from directions that differ: the number of stages may too.)
TEST_P(Lanes, ThatAreNoUnknownsStayInTheirPlaces) {
  const Shaken plain;
  const InLanes system;
  const auto a = GetParam()(), b = GetParam()();
  a->prepare(plain, {});
  b->prepare(system, {});
  State from{.t = 0.1, .x = {0.4}, .v = {0.2}, .z = {}}, to;
  State wide{.t = 0.1, .x = {0.5, 0.0, 0.4, 0.0, 0.0}, .v = {0.0, 0.0, 0.2, 0.0, 0.0}, .z = {}}, end;
  system.place(wide.t, wide.z, wide.x, wide.v);
  const bool isChebyshev = b->info().id == "rkc2";
  for (int n = 0; n < 20; ++n) {
    const StepResult first = a->step(plain, from, 0.05, to), second = b->step(system, wide, 0.05, end);
    ASSERT_TRUE(first.done && second.done) << second.failure;
    // In parts of a tolerance of 1e-6: rounding is 1e-10.
    EXPECT_NEAR(second.error, first.error, (isChebyshev ? 0.1 : 1e-6) * first.error + 1e-9);
    a->accept();
    b->accept();
    std::swap(from, to);
    std::swap(wide, end);
  }
  const double tolerance = isChebyshev ? 1e-6 : 2e-15;
  EXPECT_NEAR(wide.x[2], from.x[0], tolerance);
  EXPECT_NEAR(wide.v[2], from.v[0], tolerance);
  EXPECT_EQ(wide.x[0], 0.5);
  EXPECT_DOUBLE_EQ(wide.x[1], 0.1 * std::sin(3.0 * wide.t));
  EXPECT_EQ(wide.x[3], 0.0);
  EXPECT_EQ(wide.v[4], 0.0);
}

// A step of 0 or 4 lanes, or of many, goes through other loops: with copies of one oscillator all of them agree.
TEST_P(Lanes, AreAllTreatedAlikeHoweverMany) {
  class Copies : public DynamicalSystem {
   public:
    explicit Copies(std::size_t n) : mass_(n, 2.0) {}
    int size() const override { return static_cast<int>(mass_.size()); }
    std::span<const double> mass() const override { return mass_; }
    bool forceUsesVelocity() const override { return false; }
    void force(double t, In x, In, In, Out f) const override {
      for (std::size_t i = 0; i < x.size(); ++i) f[i] = -6.0 * std::sin(x[i]) + std::cos(t);
    }

   private:
    std::vector<double> mass_;
  };
  if (GetParam()()->info().id == "rkc2") GTEST_SKIP() << "its spectral radius depends on the number of unknowns";
  double x = 0.0, v = 0.0, error = 0.0;
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 7U, 64U, 301U}) {
    const Copies system(n);
    const auto method = GetParam()();
    method->prepare(system, {});
    State state{.t = 0.0, .x = std::vector<double>(n, 0.7), .v = std::vector<double>(n, -0.3), .z = {}}, next;
    StepResult result;
    for (int k = 0; k < 5; ++k) {
      result = method->step(system, state, 0.1, next);
      method->accept();
      std::swap(state, next);
    }
    if (n == 1) {
      x = state.x[0];
      v = state.v[0];
      error = result.error;
    }
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(state.x[i], x) << n << ' ' << i;
      ASSERT_EQ(state.v[i], v) << n << ' ' << i;
    }
    EXPECT_EQ(result.error, error) << n;
  }
}

}  // namespace
}  // namespace muelle::engine

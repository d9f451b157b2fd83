/// \file
/// Steps on every instruction set: the same numbers to the last bit, and no lane that is not looked at.

#include "engine/integrators/explicit/methods.h"
#include "engine/kernels/instruction_set.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <limits>

namespace muelle::engine {
namespace {

using kernels::InstructionSet;
using MakeMethod = std::unique_ptr<Integrator> (*)();

/// Masses of 1 between stiff and soft springs that are no line, with or without dampers: sums and products alone, which
/// are rounded in one way everywhere.
class HardeningRow : public DynamicalSystem {
 public:
  HardeningRow(std::size_t n, bool damped) : mass_(n, 1.0), damped_(damped) {}
  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return mass_; }
  bool forceUsesVelocity() const override { return damped_; }
  void force(double, In x, In v, In, Out f) const override {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double left = i == 0 ? x[i] : x[i] - x[i - 1];
      f[i] = -(3.0 + 0.1 * static_cast<double>(i % 7)) * left - left * left * left;
      if (damped_) f[i] -= 0.3 * v[i];
      if (static_cast<int>(i) == bad) f[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  int bad = -1;  ///< lane whose force is no number

 private:
  std::vector<double> mass_;
  bool damped_;
};

State thrownRow(std::size_t n) {
  State state;
  for (std::size_t i = 0; i < n; ++i) {
    state.x.push_back(0.01 * static_cast<double>(i * i % 17) - 0.05);
    state.v.push_back(0.3 - 0.1 * static_cast<double>(i * 5 % 11));
  }
  return state;
}

/// Runs `work` on each instruction set that this processor has, and goes back to the one in use.
template <class Work>
void onEachSet(Work work) {
  const InstructionSet inUse = kernels::instructionSet();
  for (const InstructionSet set : kernels::availableInstructionSets()) {
    kernels::useInstructionSet(set);
    work(set);
  }
  kernels::useInstructionSet(inUse);
}

class InstructionSets : public ::testing::TestWithParam<MakeMethod> {};
INSTANTIATE_TEST_SUITE_P(Explicit, InstructionSets,
                         ::testing::Values(symplecticEuler, velocityVerlet, takahashiImada, rungeKutta4, dop853, rkn64,
                                           nystrom8, nystrom12),
                         [](const auto& method) { return method.param()->info().id; });

TEST_P(InstructionSets, GiveTheSameStepsToTheLastBit) {
  const bool damped = !GetParam()()->info().needs.velocityFreeForce;
  // Fewer lanes than a register has, more, and with rests of each size after blocks of registers.
  for (const std::size_t n : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 11U, 16U, 19U, 31U, 32U, 33U, 45U, 76U}) {
    const HardeningRow system(n, damped);
    std::vector<State> ends;
    std::vector<double> errors;
    onEachSet([&](InstructionSet) {
      const auto method = GetParam()();
      method->prepare(system, {});
      State state = thrownRow(n), next = state;
      StepResult result;
      for (int k = 0; k < 4; ++k) {
        result = method->step(system, state, 0.03, next);
        method->accept();
        std::swap(state, next);
      }
      ends.push_back(state);
      errors.push_back(result.error);
    });
    for (std::size_t s = 1; s < ends.size(); ++s) {
      EXPECT_EQ(ends[s].x, ends[0].x) << n << " lanes, set " << s;
      EXPECT_EQ(ends[s].v, ends[0].v) << n << " lanes, set " << s;
      EXPECT_EQ(errors[s], errors[0]) << n << " lanes, set " << s;
    }
  }
}

TEST_P(InstructionSets, SeeAForceThatIsNoNumberInEveryLane) {
  const bool damped = !GetParam()()->info().needs.velocityFreeForce;
  for (const std::size_t n : {1U, 2U, 3U, 4U, 7U, 45U}) {
    HardeningRow system(n, damped);
    onEachSet([&](InstructionSet set) {
      const auto method = GetParam()();
      method->prepare(system, {});
      State next;
      for (system.bad = 0; system.bad < system.size(); ++system.bad) {
        method->restart();
        EXPECT_FALSE(method->step(system, thrownRow(n), 0.03, next).done)
            << "lane " << system.bad << " of " << n << ", " << kernels::nameOf(set);
      }
    });
  }
}

// What tells whether all is finite is a sum: that it overflows where no number does must not stop a run.
TEST(InstructionSets, TakeNumbersNearTheLargestForFinite) {
  class Free : public DynamicalSystem {
   public:
    int size() const override { return 40; }
    std::span<const double> mass() const override { return mass_; }
    bool forceUsesVelocity() const override { return false; }
    void force(double, In, In, In, Out f) const override { std::fill(f.begin(), f.end(), 0.0); }

   private:
    std::vector<double> mass_ = std::vector<double>(40, 1.0);
  };
  const Free system;
  State start;
  start.x.assign(40, 1e308);
  start.v.assign(40, 1.0);
  onEachSet([&](InstructionSet set) {
    for (const MakeMethod make : {symplecticEuler, velocityVerlet, takahashiImada, rungeKutta4}) {
      const auto method = make();
      method->prepare(system, {});
      State next;
      EXPECT_TRUE(method->step(system, start, 0.1, next).done) << method->info().id << ' ' << kernels::nameOf(set);
    }
  });
}

}  // namespace
}  // namespace muelle::engine

#include "engine/kernels/instruction_set.h"

#include "engine/kernels/kernel_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace muelle::engine::kernels {
namespace {

TEST(InstructionSets, BeginWithTheBaselineWhichIsAlwaysThere) {
  EXPECT_EQ(availableInstructionSets().front(), InstructionSet::Baseline);
  EXPECT_TRUE(isAvailable(InstructionSet::Baseline));
}

TEST(InstructionSets, HaveNames) {
  for (const InstructionSet set : availableInstructionSets()) EXPECT_EQ(instructionSetNamed(nameOf(set)), set);
}

TEST(InstructionSets, OfAnUnknownNameAreRefusedSayingWhatThereIs) {
  try {
    instructionSetNamed("mmx");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("no instruction set is called \"mmx\"; take one of: baseline"), 0U);
  }
}

TEST(InstructionSets, AreUsedAsTold) {
  const InstructionSet before = instructionSet();
  for (const InstructionSet set : availableInstructionSets()) {
    useInstructionSet(set);
    EXPECT_EQ(instructionSet(), set);
    EXPECT_NE(kernels().addSprings[2][0], nullptr);
  }
  useInstructionSet(before);
}

TEST(InstructionSets, HaveLoopsOfTheirOwn) {
  const InstructionSet before = instructionSet();
  std::vector<Kernels::ForceOfRun> loops;
  for (const InstructionSet set : availableInstructionSets()) {
    useInstructionSet(set);
    loops.push_back(kernels().forceOfRun[2][0][0]);
  }
  useInstructionSet(before);
  std::sort(loops.begin(), loops.end());
  EXPECT_EQ(std::unique(loops.begin(), loops.end()), loops.end());
}

}  // namespace
}  // namespace muelle::engine::kernels

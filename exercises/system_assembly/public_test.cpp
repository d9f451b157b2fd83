#include "course/testing/expect.h"
#include "course/testing/test_function.h"
#include "system_assembly.h"

#include <gtest/gtest.h>

// Three nodes at (0, 0, 0), (2, 0, 0) and (2, 3, 0), and a chain of two springs, one between the nodes 0 and 1 and one
// between 2 and 1. What a spring does is simple: its energy is k times the sum of the components of xb - xa, whatever
// L0 is.

namespace {

using muelle::MatX;
using muelle::TestFunction;

const TestFunction<double(const Vec3&, const Vec3&, double, double)> energy(
    "[](const Vec3& xa, const Vec3& xb, double k, double) { return k * (xb - xa).sum(); }",
    [](const Vec3& xa, const Vec3& xb, double k, double) { return k * (xb - xa).sum(); });

const TestFunction<Vec6(const Vec3&, const Vec3&, double, double)> gradient(
    "[](const Vec3&, const Vec3&, double k, double) { return Vec6{{-k, -k, -k, k, k, k}}; }",
    [](const Vec3&, const Vec3&, double k, double) {
      return Vec6{{-k, -k, -k, k, k, k}};
    });

const VecX x{{0, 0, 0, 2, 0, 0, 2, 3, 0}};
const VecX m{{1, 2, 4}};
const std::vector<Spring> springs = {{0, 1, 10, 1}, {2, 1, 100, 1}};

TEST(MassMatrix, HasEachMassThreeTimes) {
  MUELLE_PROPERTY("with the masses 1, 2 and 4 kg the diagonal reads 1 1 1 2 2 2 4 4 4, and all else is zero");
  const VecX diagonal{{1, 1, 1, 2, 2, 2, 4, 4, 4}};
  EXPECT_MATRIX_NEAR(submission::systemMassMatrix(m), MatX(diagonal.asDiagonal()), 1e-12);
}

TEST(TotalEnergy, AddsTwoSprings) {
  MUELLE_PROPERTY("spring 01 has 10 (2 + 0 + 0), spring 21 has 100 (0 - 3 + 0): -280 J together");
  EXPECT_NUMBER_NEAR(submission::systemEnergy(x, springs, energy), -280, 1e-9);
}

TEST(TotalGradient, AddsTheHalvesToTheNodes) {
  MUELLE_PROPERTY("node 1 is the second one of both springs: it gets 10 + 100 in each component");
  EXPECT_VECTOR_NEAR(submission::systemGradient(x, springs, gradient),
                     (VecX{{-10, -10, -10, 110, 110, 110, -100, -100, -100}}), 1e-9);
}

TEST(Accelerations, DivideByTheMassOfTheNode) {
  MUELLE_PROPERTY("with other forces of 20 N along z on each node: (-grad E + F) / m");
  const VecX F{{0, 0, 20, 0, 0, 20, 0, 0, 20}};
  EXPECT_VECTOR_NEAR(submission::systemAccelerations(x, m, springs, gradient, F),
                     (VecX{{10, 10, 30, -55, -55, -45, 25, 25, 30}}), 1e-9);
}

TEST(Cost, IsOneQuestionASpringAndThreeEntriesANode) {
  MUELLE_PROPERTY("two springs, two questions; three nodes, nine entries of the matrix");
  energy.forgetCalls();
  gradient.forgetCalls();
  submission::systemEnergy(x, springs, energy);
  submission::systemGradient(x, springs, gradient);
  {
    MUELLE_LABEL("how often systemEnergy asks for the energy of a spring");
    EXPECT_NUMBER_NEAR(static_cast<double>(energy.calls()), 2, 0);
  }
  {
    MUELLE_LABEL("how often systemGradient asks for the gradient of a spring");
    EXPECT_NUMBER_NEAR(static_cast<double>(gradient.calls()), 2, 0);
  }
  MUELLE_LABEL("entries that systemMassMatrix stores");
  EXPECT_NUMBER_NEAR(static_cast<double>(submission::systemMassMatrix(m).nonZeros()), 9, 0);
}

}  // namespace

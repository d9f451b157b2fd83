#include "course/testing/expect.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace muelle {
namespace {

const double inf = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

std::string numberMessage(double actual, double expected, double tolerance) {
  return numberNear("f(x)", "", "", actual, expected, tolerance).message();
}

std::string vectorMessage(const MatX& actual, const MatX& expected, double tolerance) {
  return matrixNear("F", "", "", actual, expected, tolerance).message();
}

TEST(ExpectNumber, TakesTheToleranceAsItsBound) {
  EXPECT_TRUE(numberNear("", "", "", 1.5, 1.0, 0.5));
  EXPECT_FALSE(numberNear("", "", "", 1.5000001, 1.0, 0.5));
  EXPECT_TRUE(numberNear("", "", "", -0.0, 0.0, 0.0));
}

TEST(ExpectNumber, RefusesWhatIsNotFiniteWhateverTheTolerance) {
  for (const double actual : {nan, inf, -inf}) {
    EXPECT_FALSE(numberNear("", "", "", actual, 1.0, inf));
    EXPECT_FALSE(numberNear("", "", "", actual, actual, inf));
  }
  EXPECT_FALSE(numberNear("", "", "", 1.0, nan, inf));
  EXPECT_FALSE(numberNear("", "", "", 1.0, 1.0, nan));
  EXPECT_FALSE(numberNear("", "", "", 1.0, 1.0, -1.0));
}

TEST(ExpectNumber, SaysWhatCameAndWhatShouldHave) {
  EXPECT_EQ(numberMessage(-2.0, 2.0, 1e-9), "f(x): got -2, expected 2 (difference -4, tolerance 1e-09)");
  EXPECT_EQ(numberMessage(nan, 2.0, 1e-9), "f(x): got NaN, which is not a finite number; expected 2");
}

TEST(ExpectVector, RefusesAnotherSize) {
  EXPECT_FALSE(matrixNear("", "", "", VecX::Zero(2), VecX::Zero(3), 1.0));
  EXPECT_FALSE(matrixNear("", "", "", VecX(), VecX::Zero(3), inf));
  EXPECT_FALSE(matrixNear("", "", "", MatX::Zero(1, 3), VecX::Zero(3), inf));
  EXPECT_FALSE(matrixNear("", "", "", MatX::Zero(2, 3), MatX::Zero(3, 2), inf));
  EXPECT_FALSE(matrixNear("", "", "", MatX::Zero(2, 3), MatX::Zero(2, 2), inf));
  EXPECT_TRUE(matrixNear("", "", "", VecX(), VecX(), 0.0));
  EXPECT_EQ(vectorMessage(VecX::Zero(2), VecX::Zero(3), 1.0), "F: got 2 components, expected 3 components");
  EXPECT_EQ(vectorMessage(MatX::Zero(2, 3), MatX::Zero(3, 3), 1.0), "F: got 2 x 3 entries, expected 3 x 3 entries");
}

TEST(ExpectVector, RefusesOneBadEntryAmongGoodOnes) {
  for (const double bad : {nan, inf, -inf, 3.1}) {
    for (int i = 0; i < 3; ++i) {
      Vec3 actual(1, 2, 3);
      actual[i] = bad;
      EXPECT_FALSE(matrixNear("", "", "", actual, Vec3(1, 2, 3), 0.05)) << i << " " << bad;
    }
  }
  EXPECT_FALSE(matrixNear("", "", "", Vec3(1, 2, 3), Vec3(1, nan, 3), inf));
}

TEST(ExpectVector, SaysWhichEntry) {
  EXPECT_EQ(vectorMessage(Vec3(1, 2, 3.5), Vec3(1, 2, 3), 1e-3),
            "F, component 2: got 3.5, expected 3 (difference 0.5, tolerance 0.001)");
  MatX actual = MatX::Zero(2, 2);
  actual(0, 1) = inf;
  EXPECT_EQ(vectorMessage(actual, MatX::Zero(2, 2), 1e-3),
            "F, entry (0, 1): got inf, which is not a finite number; expected 0");
}

TEST(ExpectMacros, FailTheTest) {
  EXPECT_NONFATAL_FAILURE(EXPECT_VECTOR_NEAR(Vec3(1, 2, 3), Vec3(1, 2, 4), 0.5), "component 2: got 3, expected 4");
  EXPECT_NONFATAL_FAILURE(EXPECT_MATRIX_NEAR(Mat2::Identity(), Mat2::Zero(), 0.5), "entry (0, 0): got 1");
  EXPECT_NONFATAL_FAILURE(EXPECT_NUMBER_NEAR(1.0, 2.0, 0.5), "1.0: got 1, expected 2");
  EXPECT_VECTOR_NEAR(Vec3(1, 2, 3) + Vec3::Ones(), Vec3(2, 3, 4), roundOff(1.0));
}

TEST(ExpectLabel, StandsInPlaceOfTheSource) {
  MUELLE_LABEL("height at t = 0.35 s", "m");
  EXPECT_EQ(numberMessage(1.5, 1.0, 1e-3),
            "height at t = 0.35 s: got 1.5 m, expected 1 m (difference 0.5, tolerance 0.001)");
  {
    MUELLE_LABEL("velocity");
    EXPECT_EQ(vectorMessage(Vec3(1, 2, 3), Vec3(1, 2, 4), 1e-3),
              "velocity, component 2: got 3, expected 4 (difference -1, tolerance 0.001)");
  }
  EXPECT_EQ(numberMessage(nan, 1.0, 1e-3), "height at t = 0.35 s: got NaN, which is not a finite number; expected 1 m");
}

TEST(ExpectLabel, EndsWithItsScope) {
  { MUELLE_LABEL("height", "m"); }
  EXPECT_EQ(numberMessage(1.5, 1.0, 1e-3), "f(x): got 1.5, expected 1 (difference 0.5, tolerance 0.001)");
}

TEST(ExpectMismatch, KeepsEveryNumberOfAMatrix) {
  MatX actual = MatX::Zero(2, 3);
  actual(1, 2) = -0.1;
  const auto result = matrixNear("submission::f(submission::g(x))", "", "", actual, MatX::Zero(2, 3), 0.05);
  const std::optional<Mismatch> taken = takeMismatch(std::string(result.message()) + "\nstreamed words");
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(taken->expression, "f(g(x))");
  EXPECT_TRUE(taken->ofCall);
  EXPECT_EQ(taken->row, 1);
  EXPECT_EQ(taken->col, 2);
  EXPECT_EQ(taken->rows, 2);
  EXPECT_EQ(taken->cols, 3);
  EXPECT_EQ(taken->got, -0.1);
  EXPECT_EQ(taken->expected, 0.0);
  EXPECT_EQ(taken->tolerance, 0.05);
  EXPECT_FALSE(takeMismatch(result.message())) << "taken twice";
}

TEST(ExpectMismatch, KeepsBothSizes) {
  const auto result = matrixNear("F", "", "", VecX::Zero(2), VecX::Zero(3), 1.0);
  const std::optional<Mismatch> taken = takeMismatch(result.message());
  ASSERT_TRUE(taken.has_value());
  EXPECT_TRUE(taken->isSize());
  EXPECT_EQ(taken->gotRows, 2);
  EXPECT_EQ(taken->rows, 3);
}

TEST(ExpectMismatch, IsNotTakenForAnotherFailure) {
  EXPECT_FALSE(numberNear("f(x)", "", "", 1.0, 2.0, 0.1));
  EXPECT_FALSE(takeMismatch("Failed"));
  EXPECT_FALSE(numberNear("f(x)", "", "", 1.0, 2.0, 0.1));
  EXPECT_TRUE(numberNear("f(x)", "", "", 2.0, 2.0, 0.1));
  EXPECT_FALSE(takeMismatch(numberMessage(1.0, 2.0, 0.1).substr(1)));
}

TEST(ExpectMacros, RecordTheProperty) {
  MUELLE_PROPERTY("momentum is conserved");
  const auto* result = ::testing::UnitTest::GetInstance()->current_test_info()->result();
  ASSERT_EQ(result->test_property_count(), 1);
  EXPECT_STREQ(result->GetTestProperty(0).key(), "property");
  EXPECT_STREQ(result->GetTestProperty(0).value(), "momentum is conserved");
}

}  // namespace
}  // namespace muelle

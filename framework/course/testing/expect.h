#pragma once
/// \file
/// Strict comparisons for the tests of an exercise, public and hidden.
///
/// A wrong size, a NaN or an infinity fails, whatever the tolerance. A failure leaves a Mismatch for the listener, with
/// the index, the expected and the received value and the tolerance; the message is its sentence. Tolerances are
/// absolute, in the unit of what is compared; `roundOff(scale)` gives the usual one. What an expectation compares is
/// named by MUELLE_LABEL, not by words streamed into it, which no report shows.

#include "course/testing/mismatch.h"
#include "harness/types.h"

#include <gtest/gtest.h>

namespace muelle {

/// A tolerance for a closed form that is evaluated in a different order: 1e-9 of the scale of the numbers involved.
/// (A handful of roundings costs about 1e-15; 1e-9 leaves room for every sensible way to write the formula, while the
/// mistakes looked for change the value by far more.)
inline double roundOff(double scale) { return 1e-9 * scale; }

/// EXPECT_NUMBER_NEAR: |actual - expected| <= tolerance, actual finite.
::testing::AssertionResult numberNear(const char* actualText, const char* expectedText, const char* toleranceText,
                                      double actual, double expected, double tolerance);

/// EXPECT_VECTOR_NEAR and EXPECT_MATRIX_NEAR: same size, every entry finite and within the tolerance.
::testing::AssertionResult matrixNear(const char* actualText, const char* expectedText, const char* toleranceText,
                                      const MatX& actual, const MatX& expected, double tolerance);

}  // namespace muelle

#define EXPECT_NUMBER_NEAR(actual, expected, tolerance) \
  EXPECT_PRED_FORMAT3(::muelle::numberNear, actual, expected, tolerance)
#define EXPECT_VECTOR_NEAR(actual, expected, tolerance) \
  EXPECT_PRED_FORMAT3(::muelle::matrixNear, actual, expected, tolerance)
#define EXPECT_MATRIX_NEAR(actual, expected, tolerance) \
  EXPECT_PRED_FORMAT3(::muelle::matrixNear, actual, expected, tolerance)
#define ASSERT_NUMBER_NEAR(actual, expected, tolerance) \
  ASSERT_PRED_FORMAT3(::muelle::numberNear, actual, expected, tolerance)
#define ASSERT_VECTOR_NEAR(actual, expected, tolerance) \
  ASSERT_PRED_FORMAT3(::muelle::matrixNear, actual, expected, tolerance)

#define MUELLE_JOINED(a, b) a##b
#define MUELLE_NAME_WITH(prefix, line) MUELLE_JOINED(prefix, line)

/// Names what the expectations of the rest of this scope compare, and their unit, in the student's words:
/// MUELLE_LABEL("height at t = 0.35 s", "m"); the reports show it in place of the test's source.
#define MUELLE_LABEL(...) const ::muelle::MismatchLabel MUELLE_NAME_WITH(muelleLabel, __LINE__)(__VA_ARGS__)

/// Says in one sentence what the test asks for, in the student's words: the feedback of level `property` shows it.
/// First line of every TEST: MUELLE_PROPERTY("the force pulls a towards b when the spring is stretched");
#define MUELLE_PROPERTY(sentence) ::testing::Test::RecordProperty("property", sentence)

#include "course/testing/expect.h"

#include "course/testing/common_mistake.h"

#include <cmath>
#include <string_view>
#include <utility>

namespace muelle {

namespace {

bool near(double actual, double expected, double tolerance) {
  return std::isfinite(actual) && std::abs(actual - expected) <= tolerance;
}

/// A mismatch that knows what was compared, and no number yet.
Mismatch mismatchOf(const char* actualText, double tolerance) {
  Mismatch mismatch;
  if (const MismatchLabel* label = MismatchLabel::current()) {
    mismatch.label = label->label();
    mismatch.unit = label->unit();
  }
  mismatch.expression = asStudentsWrite(actualText);
  mismatch.ofCall = std::string_view(actualText).starts_with("submission::");
  mismatch.tolerance = tolerance;
  return mismatch;
}

::testing::AssertionResult success() {
  noteMismatch(std::nullopt);
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult failure(Mismatch mismatch) {
  const std::string message = sentence(mismatch);
  noteMismatch(std::move(mismatch));
  return ::testing::AssertionFailure() << message;
}

}  // namespace

::testing::AssertionResult numberNear(const char* actualText, const char*, const char*, double actual, double expected,
                                      double tolerance) {
  noteComparison(actualText, {&actual, 1}, {&expected, 1}, tolerance);
  if (near(actual, expected, tolerance)) return success();
  Mismatch mismatch = mismatchOf(actualText, tolerance);
  mismatch.got = actual;
  mismatch.expected = expected;
  return failure(std::move(mismatch));
}

::testing::AssertionResult matrixNear(const char* actualText, const char*, const char*, const MatX& actual,
                                      const MatX& expected, double tolerance) {
  const auto shaped = [&] {
    Mismatch mismatch = mismatchOf(actualText, tolerance);
    mismatch.rows = expected.rows();
    mismatch.cols = expected.cols();
    mismatch.gotRows = actual.rows();
    mismatch.gotCols = actual.cols();
    return mismatch;
  };
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols()) return failure(shaped());
  const auto numbers = [](const MatX& m) { return std::span(m.data(), static_cast<std::size_t>(m.size())); };
  noteComparison(actualText, numbers(actual), numbers(expected), tolerance);
  for (Eigen::Index col = 0; col < expected.cols(); ++col) {
    for (Eigen::Index row = 0; row < expected.rows(); ++row) {
      if (near(actual(row, col), expected(row, col), tolerance)) continue;
      Mismatch mismatch = shaped();
      mismatch.row = row;
      mismatch.col = col;
      mismatch.got = actual(row, col);
      mismatch.expected = expected(row, col);
      return failure(std::move(mismatch));
    }
  }
  return success();
}

}  // namespace muelle

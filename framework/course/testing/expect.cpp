#include "course/testing/expect.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle {

namespace {

/// "component 2" of a vector, "entry (1, 2)" of a matrix.
std::string place(const MatX& m, Eigen::Index row, Eigen::Index col) {
  return m.cols() == 1 ? fmt::format("component {}", row) : fmt::format("entry ({}, {})", row, col);
}

std::string size(const MatX& m) {
  return m.cols() == 1 ? fmt::format("{} components", m.rows()) : fmt::format("{} x {} entries", m.rows(), m.cols());
}

std::string comparison(double actual, double expected, double tolerance) {
  if (!std::isfinite(actual))
    return fmt::format("got {}, which is not a finite number; expected {:.10g}", actual, expected);
  return fmt::format("got {:.10g}, expected {:.10g} (difference {:.3g}, tolerance {:.3g})", actual, expected,
                     actual - expected, tolerance);
}

bool near(double actual, double expected, double tolerance) {
  return std::isfinite(actual) && std::abs(actual - expected) <= tolerance;
}

}  // namespace

::testing::AssertionResult numberNear(const char* actualText, const char*, const char*, double actual, double expected,
                                      double tolerance) {
  if (near(actual, expected, tolerance)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << actualText << ": " << comparison(actual, expected, tolerance);
}

::testing::AssertionResult matrixNear(const char* actualText, const char*, const char*, const MatX& actual,
                                      const MatX& expected, double tolerance) {
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols()) {
    return ::testing::AssertionFailure() << actualText << ": got " << size(actual) << ", expected " << size(expected);
  }
  for (Eigen::Index col = 0; col < expected.cols(); ++col) {
    for (Eigen::Index row = 0; row < expected.rows(); ++row) {
      if (near(actual(row, col), expected(row, col), tolerance)) continue;
      return ::testing::AssertionFailure() << actualText << ", " << place(expected, row, col) << ": "
                                           << comparison(actual(row, col), expected(row, col), tolerance);
    }
  }
  return ::testing::AssertionSuccess();
}

}  // namespace muelle

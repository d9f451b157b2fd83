#include "course/testing/print_value.h"

#include "base/text/lists.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle {

namespace {

template <class Number>
std::string print(Number value) {
  if (std::isnan(value)) return "NAN";
  if (std::isinf(value)) return value > 0 ? "INFINITY" : "-INFINITY";
  return fmt::format("{}", value);
}

}  // namespace

std::string printNumber(double value) { return print(value); }
std::string printNumber(float value) { return print(value); }

std::string printCallOf(const std::string& function, const std::vector<std::string>& arguments) {
  return function + "(" + joined(arguments, ", ") + ")";
}

std::string detail::matrixName(int rows, int cols) {
  const auto size = [](int n) { return n == Eigen::Dynamic ? std::string("X") : std::to_string(n); };
  if (cols == 1) return "Vec" + size(rows);
  if (rows == cols) return "Mat" + size(rows);
  if (rows == Eigen::Dynamic || cols == Eigen::Dynamic) return "MatX";
  return fmt::format("Eigen::Matrix<double, {}, {}>", rows, cols);
}

}  // namespace muelle

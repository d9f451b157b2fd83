#include "course/check/eigen_message.h"

#include "base/text/words.h"

#include <fmt/format.h>
#include <charconv>
#include <optional>

namespace muelle {

namespace {

/// The value of a template parameter in "... [with Derived = Eigen::Matrix<double, 3, 1>; Scalar = double]".
std::string_view parameter(std::string_view prettyFunction, std::string_view name) {
  const std::string key = fmt::format("{} = ", name);
  std::size_t start = prettyFunction.find("[with " + key);
  start = start != std::string_view::npos ? start + 6 : prettyFunction.find("; " + key);
  if (start == std::string_view::npos) return {};
  std::string_view value = prettyFunction.substr(prettyFunction.find(key, start) + key.size());
  int depth = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (value[i] == '<') ++depth;
    if (value[i] == '>') --depth;
    if (depth <= 0 && (value[i] == ';' || value[i] == ']')) return value.substr(0, i);
  }
  return value;
}

/// Rows and columns of "Eigen::Matrix<double, 3, 1>"; -1 is a run-time size.
std::optional<std::pair<int, int>> matrixSize(std::string_view type) {
  const std::string_view begin = "Eigen::Matrix<";
  if (type.starts_with("const ")) type.remove_prefix(6);
  if (!type.starts_with(begin)) return std::nullopt;
  int size[2] = {0, 0};
  std::size_t at = begin.size();
  for (int& extent : size) {
    at = type.find(", ", at);
    if (at == std::string_view::npos) return std::nullopt;
    at += 2;
    if (std::from_chars(type.data() + at, type.data() + type.size(), extent).ec != std::errc()) return std::nullopt;
  }
  return std::pair(size[0], size[1]);
}

/// "of a 3-vector", from the object whose member function asserts.
std::string object(std::string_view prettyFunction) {
  std::string_view type = parameter(prettyFunction, "Derived");
  if (type.empty()) type = parameter(prettyFunction, "XprType");
  const std::string name = eigenTypeName(type);
  return fmt::format("{} {}", name.starts_with('e') ? "an" : "a", name);
}

std::string withoutPlace(std::string_view condition, std::string_view function, AssertedIndex index) {
  if (contains(condition, "row >= 0 && row < rows()") || contains(condition, "row>=0 && row<rows()")) {
    return fmt::format("row or column out of range of {}", object(function));
  }
  if (contains(condition, "index >= 0 && index < size()") || contains(condition, "index<size()")) {
    return index.known ? fmt::format("index {} of {}", index.value, object(function))
                       : fmt::format("index out of range of {}", object(function));
  }
  if (contains(condition, "invalid matrix product"))
    return "product of a matrix and a vector or matrix whose sizes do not fit";
  if (contains(condition, "Too few coefficients"))
    return "too few numbers after << for the size of the vector or matrix";
  if (contains(condition, "comma initializer")) return "too many numbers after << for the size of the vector or matrix";
  if (contains(condition, "startRow") || contains(condition, "startCol") || contains(condition, "BlockRows==1")) {
    return "block, segment, row or column outside of the vector or matrix";
  }
  if (contains(condition, "empty matrix")) return "an empty vector or matrix has no such value";
  if (contains(condition, "does not actually allow to resize") || contains(condition, "RowsAtCompileTime!=Dynamic") ||
      contains(condition, "v == T(Value)")) {
    return "wrong number of components for a vector or matrix of fixed size (a Vec3 takes three numbers)";
  }
  if (contains(condition, "not initialized")) return "a decomposition is used before compute()";
  if (contains(condition, "size() == other.size()")) return "dot product of vectors of different sizes";
  if (contains(condition, "rows() == ") || contains(condition, "cols() == ") || contains(condition, "rows()==")) {
    return "vectors or matrices of different sizes are added, subtracted or assigned";
  }
  return fmt::format("Eigen refused an operation: '{}' does not hold", condition);
}

}  // namespace

std::string eigenTypeName(std::string_view type) {
  const auto size = matrixSize(type);
  if (!size) return "expression";
  const auto [rows, cols] = *size;
  if (cols == 1) return rows < 0 ? "vector" : fmt::format("{}-vector", rows);
  if (rows == 1) return cols < 0 ? "row vector" : fmt::format("row {}-vector", cols);
  return rows < 0 || cols < 0 ? "matrix" : fmt::format("{} x {} matrix", rows, cols);
}

std::string eigenMessage(std::string_view condition, std::string_view prettyFunction, AssertedIndex index,
                         std::string_view where) {
  const std::string what = withoutPlace(condition, prettyFunction, index);
  return where.empty() ? what : fmt::format("{} in {}", what, where);
}

}  // namespace muelle

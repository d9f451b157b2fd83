#pragma once
/// \file
/// Values as C++ source: what a student can paste to repeat a failing call.

#include "course/testing/struct_fields.h"
#include "course/testing/test_function.h"
#include "harness/types.h"

#include <array>
#include <concepts>
#include <functional>
#include <string>
#include <vector>

namespace muelle {

/// Shortest text that reads back as the same number; "NAN" and "INFINITY" for what has no digits.
std::string printNumber(double value);
std::string printNumber(float value);

inline std::string printValue(bool value) { return value ? "true" : "false"; }
inline std::string printValue(double value) { return printNumber(value); }
inline std::string printValue(float value) { return printNumber(value); }
inline std::string printValue(std::integral auto value) { return std::to_string(value); }
inline std::string printValue(const std::string& value) { return '"' + value + '"'; }

template <class Result, class... Args>
std::string printValue(const std::function<Result(Args...)>& function);
template <class T>
std::string printValue(const std::vector<T>& values);
template <class T, std::size_t N>
std::string printValue(const std::array<T, N>& values);
template <DescribedStruct T>
std::string printValue(const T& object);
template <class Derived>
std::string printValue(const Eigen::MatrixBase<Derived>& m);
template <class Derived>
std::string printValue(const Eigen::SparseMatrixBase<Derived>& m);

namespace detail {

/// Of longer lists and vectors the first members are shown: nobody reads a mesh of 4000 triangles, or types it.
inline constexpr std::size_t longestList = 300, membersShown = 12;

inline std::string andMore(std::size_t count) { return ", /* and " + std::to_string(count) + " more */"; }

template <class Range>
std::string printList(const Range& values) {
  const std::size_t shown = values.size() > longestList ? membersShown : values.size();
  std::string text = "{";
  for (std::size_t i = 0; i < shown; ++i) text += (i > 0 ? ", " : "") + printValue(values[i]);
  if (shown < values.size()) text += andMore(values.size() - shown);
  return text + "}";
}

/// "Vec3", "VecX", "MatX" ... : the name that harness/types.h gives to the type.
std::string matrixName(int rows, int cols);

}  // namespace detail

/// A function argument cannot be written out, unless it has its source with it.
template <class Result, class... Args>
std::string printValue(const std::function<Result(Args...)>& function) {
  const auto* written = function.template target<TestFunction<Result(Args...)>>();
  return written != nullptr ? written->source() : "/* a function of the test */";
}

template <class T>
std::string printValue(const std::vector<T>& values) {
  return detail::printList(values);
}

template <class T, std::size_t N>
std::string printValue(const std::array<T, N>& values) {
  return detail::printList(values);
}

/// Name{field, field}
template <DescribedStruct T>
std::string printValue(const T& object) {
  std::string fields;
  visitFields(object, [&fields](const auto& field) { fields += (fields.empty() ? "" : ", ") + printValue(field); });
  return std::string(structName(&object)) + "{" + fields + "}";
}

/// The dense matrix and the call that makes it sparse again. Needs <Eigen/SparseCore> where it is used.
template <class Derived>
std::string printValue(const Eigen::SparseMatrixBase<Derived>& m) {
  return printValue(MatX(m)) + ".sparseView()";
}

/// Vec3(1, 2, 3) up to three components, Vec9{{...}} and MatX{{...}, {...}} beyond.
template <class Derived>
std::string printValue(const Eigen::MatrixBase<Derived>& m) {
  constexpr int Rows = Derived::RowsAtCompileTime;
  constexpr int Cols = Derived::ColsAtCompileTime;
  const auto rowText = [&m](Eigen::Index row) {
    std::string text;
    for (Eigen::Index col = 0; col < m.cols(); ++col) text += (col > 0 ? ", " : "") + printValue(m(row, col));
    return text;
  };
  const bool isVector = Cols == 1;
  const bool isShort = isVector && (Rows == 2 || Rows == 3);
  const bool isLong = isVector && m.rows() > static_cast<Eigen::Index>(detail::longestList);
  const Eigen::Index shown = isLong ? static_cast<Eigen::Index>(detail::membersShown) : m.rows();
  std::string text;
  for (Eigen::Index row = 0; row < shown; ++row) {
    if (row > 0) text += ", ";
    text += isVector ? rowText(row) : "{" + rowText(row) + "}";
  }
  if (isLong) text += detail::andMore(static_cast<std::size_t>(m.rows() - shown));
  const std::string name = detail::matrixName(Rows, Cols);
  if (m.size() == 0) return name + (isVector ? "(0)" : "(" + printValue(m.rows()) + ", " + printValue(m.cols()) + ")");
  if (isShort) return name + "(" + text + ")";
  return isVector ? name + "{{" + text + "}}" : name + "{" + text + "}";
}

/// f(a, b, c) of arguments that are source already.
std::string printCallOf(const std::string& function, const std::vector<std::string>& arguments);

/// f(a, b, c)
template <class... Args>
std::string printCall(const char* function, const Args&... args) {
  return printCallOf(function, {printValue(args)...});
}

}  // namespace muelle

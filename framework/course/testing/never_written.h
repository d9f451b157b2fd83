#pragma once
/// \file
/// Memory to which nothing was written, told by the bits with which it was filled.
///
/// A student's file is compiled so that local variables hold a pattern and Eigen's objects NaN before anything is
/// written; the heap is filled by the allocator. A number that comes back with these bits was never computed.

#include "course/testing/struct_fields.h"
#include "harness/types.h"

#include <array>
#include <concepts>
#include <functional>
#include <string>
#include <vector>

namespace muelle {

/// True for the fill, and for what arithmetic makes of it.
bool isFill(double value);

/// True for the fill of an integer of 32 or 64 bits: an index that was never written.
bool isFillInteger(long value);

/// "returned memory to which nothing was written: give every variable a value before it is read"; the function's name
/// goes before it.
const char* neverWrittenSentence();

inline bool holdsFill(double value) { return isFill(value); }
inline bool holdsFill(float) { return false; }
inline bool holdsFill(std::integral auto) { return false; }
inline bool holdsFill(const std::string&) { return false; }

template <class Result, class... Args>
bool holdsFill(const std::function<Result(Args...)>&);
template <class T>
bool holdsFill(const std::vector<T>& values);
template <class T, std::size_t N>
bool holdsFill(const std::array<T, N>& values);
template <DescribedStruct T>
bool holdsFill(const T& object);
template <class Derived>
bool holdsFill(const Eigen::MatrixBase<Derived>& m);
template <class Derived>
bool holdsFill(const Eigen::SparseMatrixBase<Derived>& m);

template <class Result, class... Args>
bool holdsFill(const std::function<Result(Args...)>&) {
  return false;
}

template <class T>
bool holdsFill(const std::vector<T>& values) {
  for (const T& value : values) {
    if (holdsFill(value)) return true;
  }
  return false;
}

template <class T, std::size_t N>
bool holdsFill(const std::array<T, N>& values) {
  for (const T& value : values) {
    if (holdsFill(value)) return true;
  }
  return false;
}

/// In any of its fields.
template <DescribedStruct T>
bool holdsFill(const T& object) {
  bool found = false;
  visitFields(object, [&found](const auto& field) { found = found || holdsFill(field); });
  return found;
}

template <class Derived>
bool holdsFill(const Eigen::MatrixBase<Derived>& m) {
  for (Eigen::Index col = 0; col < m.cols(); ++col) {
    for (Eigen::Index row = 0; row < m.rows(); ++row) {
      if (holdsFill(m(row, col))) return true;
    }
  }
  return false;
}

/// Needs <Eigen/SparseCore> where it is used.
template <class Derived>
bool holdsFill(const Eigen::SparseMatrixBase<Derived>& m) {
  return holdsFill(MatX(m));
}

}  // namespace muelle

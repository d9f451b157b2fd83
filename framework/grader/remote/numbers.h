#pragma once
/// \file
/// Every number in a value, in order: what two answers are compared by.

#include "grader/wire/codec.h"

#include <functional>

namespace muelle::grader {

inline void appendNumbers(std::vector<double>& list, wire::Number auto value) {
  list.push_back(static_cast<double>(value));
}
inline void appendNumbers(std::vector<double>& list, const std::string& text) {
  for (const char c : text) list.push_back(c);
}
template <int Rows, int Cols, int Options>
void appendNumbers(std::vector<double>& list, const Eigen::Matrix<double, Rows, Cols, Options>& m) {
  list.insert(list.end(), m.data(), m.data() + m.size());
}
/// Entry by entry; one that is too large to be anybody's answer counts by its shape alone.
void appendNumbers(std::vector<double>& list, const wire::Sparse& m);
template <class Result, class... Args>
void appendNumbers(std::vector<double>&, const std::function<Result(Args...)>&) {}
template <class T, std::size_t N>
void appendNumbers(std::vector<double>& list, const std::array<T, N>& values);
template <DescribedStruct T>
void appendNumbers(std::vector<double>& list, const T& object);
template <class T>
void appendNumbers(std::vector<double>& list, const std::vector<T>& values) {
  for (const auto& value : values) appendNumbers(list, static_cast<const T&>(value));
}
template <class T, std::size_t N>
void appendNumbers(std::vector<double>& list, const std::array<T, N>& values) {
  for (const auto& value : values) appendNumbers(list, value);
}
template <DescribedStruct T>
void appendNumbers(std::vector<double>& list, const T& object) {
  visitFields(object, [&list](const auto& field) { appendNumbers(list, field); });
}

/// The same count, and every number within 1e-6 of the larger scale of the two lists plus `floor` (NaN agrees with NaN,
/// an infinity with itself).
bool agree(const std::vector<double>& a, const std::vector<double>& b, double floor);

/// Largest finite magnitude in a list, 0 when there is none.
double scaleOf(const std::vector<double>& list);

}  // namespace muelle::grader

#pragma once
#include "harness/eigen_assertion.h"

#include <string>
#include <string_view>

namespace muelle {

/// Name of an Eigen type as the course says it: "3-vector", "3 x 3 matrix", "vector" (of run-time length),
/// "expression". \param type what the compiler writes: "Eigen::Matrix<double, 3, 1>"
std::string eigenTypeName(std::string_view type);

/// What an assertion of Eigen means to the student: "index 3 of a 3-vector in springForce".
/// \param condition the assertion's text   \param prettyFunction the compiler's name of the function that asserts
/// \param index what eigenAssertionFailed() was given
/// \param where the student's function that was running, or other words for the place; "" leaves it out
std::string eigenMessage(std::string_view condition, std::string_view prettyFunction, AssertedIndex index,
                         std::string_view where);

}  // namespace muelle

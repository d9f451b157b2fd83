#pragma once
#include "harness/state.h"

#include <Eigen/Core>

namespace muelle::engine {

/// A vector as the forces of a system take it: to read, or to write to.
inline In spanOf(const Eigen::VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }
inline Out spanOf(Eigen::VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

}  // namespace muelle::engine

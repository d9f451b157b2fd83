#pragma once
#include <cstddef>

namespace muelle::grader::worker {

/// Limits of the process that runs a student's code.
inline constexpr std::size_t addressSpace = 1024UL * 1024 * 1024;  ///< [bytes]
inline constexpr std::size_t stack = 8UL * 1024 * 1024;            ///< [bytes]
inline constexpr unsigned cpuSeconds = 20;  ///< processor time; the test process's own limits come first

/// Sets them for this process, hard, along with no core file, no growing file and no further process or thread.
void applyLimits();

}  // namespace muelle::grader::worker

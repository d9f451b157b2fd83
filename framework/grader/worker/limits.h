#pragma once
#include "grader/worker/sanitised.h"

#include <cstddef>

namespace muelle::grader::worker {

/// Limits of the process that runs a student's code.
inline constexpr std::size_t addressSpace = 1024UL * 1024 * 1024;  ///< [bytes]
/// [bytes]; a frame with sanitizers in it is several times larger
inline constexpr std::size_t stack = (isSanitised ? 64UL : 8UL) * 1024 * 1024;

/// Sets them for this process, hard, along with no core file, no growing file and no further process or thread.
/// \param cpuSeconds processor time at which SIGXCPU ends the process; the test process's own limits come first.
/// The hard limit, met by SIGKILL, lies above: a death by SIGKILL stays a word of the machine's.
void applyLimits(unsigned cpuSeconds);

}  // namespace muelle::grader::worker

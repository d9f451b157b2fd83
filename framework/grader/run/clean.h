#pragma once
#include "grader/run/workplace.h"

#include <cstdint>

namespace muelle::grader {

/// Removes everything that is kept between runs (compiled hand-ins, verdicts, curves) but the seed, which the inputs of
/// every later grading derive from. Returns the bytes removed. Throws std::runtime_error when something cannot be
/// removed.
std::uintmax_t clean(const Workplace& workplace);

}  // namespace muelle::grader

#pragma once
#include "harness/types.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle::grader {

/// Expects a force to keep its direction, and to follow the power law of its first two lengths, down to the last. An
/// edge is judged by this: a force that is wrong by a factor, or by a power of the length, is right there as it is
/// elsewhere. Nothing is expected of one that is zero, or no number, at the first length already: that is a wrong
/// value. \param what "force at a depth" \param bend how far the right force may be from the law, relative to it
void expectPowerLaw(const std::vector<double>& lengths, const std::function<Vec3(double length)>& force,
                    const std::string& what, double bend);

}  // namespace muelle::grader

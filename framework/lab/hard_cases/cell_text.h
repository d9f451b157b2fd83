#pragma once
#include "lab/hard_cases/matrix.h"

#include <string>

namespace muelle::hard_cases {

/// "1e-09", or "stopped" where the error is not finite.
std::string errorText(double error);
/// "1e-09", "~3e+02", "n/a", "!1e-01": passed, failed as predicted, not applicable, failed unexpectedly.
std::string cellText(const Cell& cell);
/// Short names for the columns: "explicit_euler" -> "EE".
std::string shortName(const std::string& method);

}  // namespace muelle::hard_cases

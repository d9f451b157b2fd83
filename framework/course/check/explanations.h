#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// What a compiler's message means to a student, and what to do; "" when the message says it.
/// \param message the compiler's, types still in full   \param mixed names of the Eigen types around (matrixNamesIn())
std::string explainMessage(std::string_view message, const std::vector<std::string>& mixed);

}  // namespace muelle

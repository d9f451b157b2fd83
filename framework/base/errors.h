#pragma once
#include <functional>

namespace muelle {

/// Runs a program's body: an exception becomes one line "muelle: ..." on the standard error stream and exit code 2.
int withErrorsOnOneLine(const std::function<int()>& body);

}  // namespace muelle

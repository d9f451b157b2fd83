#pragma once
#include <functional>

namespace muelle {

/// Runs a program's body: an exception becomes one line "muelle: ..." on the standard error stream and exit code 2. So
/// does standard output that cannot be written, at the end or before: a full disk, a closed stream, a reader that is
/// gone.
int withErrorsOnOneLine(const std::function<int()>& body);

}  // namespace muelle

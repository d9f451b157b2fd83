#pragma once
#include <string>
#include <vector>

namespace muelle::app {

/// Runs tests of this build with CTest in the foreground, as many at a time as the machine has cores.
/// \param selection further arguments of ctest; it is an error that they select nothing   \return 0 or 1
int runCtest(const std::vector<std::string>& selection);

}  // namespace muelle::app

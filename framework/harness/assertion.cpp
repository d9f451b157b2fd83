/// \file
/// The default answer to a refused operation of Eigen. Nothing else stands in this file: the linker takes a program's
/// own eigenAssertionFailed() instead, because nothing else makes it pull this member from the archive.

#include "harness/eigen_assertion.h"

#include <cstdio>
#include <cstdlib>

namespace muelle {

void eigenAssertionFailed(const char* condition, const char* function, AssertedIndex index) {
  if (index.known) {
    std::fprintf(stderr, "Eigen refused index %ld: '%s' does not hold in %s\n", index.value, condition, function);
  } else {
    std::fprintf(stderr, "Eigen refused an operation: '%s' does not hold in %s\n", condition, function);
  }
  std::abort();
}

}  // namespace muelle

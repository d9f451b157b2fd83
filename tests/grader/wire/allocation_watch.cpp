#include "allocation_watch.h"

#include <algorithm>

namespace {

std::size_t largest = 0;

}  // namespace

#ifndef __SANITIZE_ADDRESS__
// glibc's own name of the function that this one stands in front of: Eigen allocates by malloc, not by new.
extern "C" void* __libc_malloc(std::size_t bytes);
extern "C" void* malloc(std::size_t bytes) {
  largest = std::max(largest, bytes);
  return __libc_malloc(bytes);
}
#endif

namespace wire_test {

std::size_t largestAllocation() { return largest; }
void forgetAllocations() { largest = 0; }

}  // namespace wire_test

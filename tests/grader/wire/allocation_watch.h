#pragma once
#include <cstddef>

namespace wire_test {

/// Largest block [bytes] that has been asked for since forgetAllocations(); 0 where a sanitizer owns the heap.
std::size_t largestAllocation();
void forgetAllocations();

}  // namespace wire_test

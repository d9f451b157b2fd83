/// \file
/// Memory that grows is filled as fresh memory is. glibc's M_PERTURB fills what malloc returns, not what realloc adds
/// to a block; that mostly holds zeros, so that a sum over entries of Eigen's conservativeResize() to which nothing was
/// written would be right by chance. Whoever loads a student's file is linked with this.

#include <algorithm>
#include <cstdlib>
#include <cstring>

#ifdef __GLIBC__
#ifndef __SANITIZE_ADDRESS__  // which has an allocator of its own
#include <malloc.h>

/// In place of the C library's: a fresh block each time. \throws nothing; nullptr when there is no memory
extern "C" void* realloc(void* old, std::size_t bytes) noexcept {
  if (old != nullptr && bytes == 0) {
    std::free(old);
    return nullptr;
  }
  void* fresh = std::malloc(bytes);
  if (old == nullptr || fresh == nullptr) return fresh;
  std::memcpy(fresh, old, std::min(bytes, malloc_usable_size(old)));
  std::free(old);
  return fresh;
}
#endif
#endif

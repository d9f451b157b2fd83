#pragma once
/// \file
/// How a student's file is compiled, in `check` and in the grader alike.

#include <cstddef>
#include <string>
#include <vector>

namespace muelle {

/// What one compilation may take.
struct CompileLimits {
  unsigned cpuSeconds = 20;                        ///< of processor time, all tools together
  std::size_t memory = 2048UL * 1024 * 1024;       ///< [bytes] of address space, each tool
  std::size_t words = 64UL * 1024;                 ///< [bytes] of diagnostics that are kept
};
inline constexpr CompileLimits compileLimits;

/// Language, optimisation, warnings, fills of uninitialised memory, the compiler's own limits, and how it words things.
std::vector<std::string> studentCompileFlags();

/// The same with AddressSanitizer and a check for missing returns, without the precompiled header: for the second look.
std::vector<std::string> sanitisedCompileFlags();
std::vector<std::string> sanitisedLinkFlags();

}  // namespace muelle

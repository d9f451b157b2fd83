#pragma once
#include <string_view>

namespace muelle::grader::worker {

/// How the cause begins when nobody caught an exception; its text follows.
inline constexpr std::string_view uncaughtException = "uncaught exception: ";

/// Tells the test process the cause of death and ends the process. Allocates nothing: the heap may be broken.
[[noreturn]] void dieSaying(const char* cause);

}  // namespace muelle::grader::worker

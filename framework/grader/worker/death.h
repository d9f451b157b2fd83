#pragma once
#include <string_view>

namespace muelle::grader::worker {

/// How the cause begins when nobody caught an exception; its text follows.
inline constexpr std::string_view uncaughtException = "uncaught exception: ";

/// The cause when a signal came that nothing in the process has caused.
inline constexpr std::string_view signalFromOutside = "signal from outside";

/// The cause when the processor met an instruction that stops a program for a debugger: a way without return.
inline constexpr std::string_view traceTrap = "trace trap";

/// The cause when it wrote where nobody reads any more, or beyond a limit of size.
inline constexpr std::string_view vainWrite = "vain write";

/// Tells the test process the cause of death and ends the process. Allocates nothing: the heap may be broken.
[[noreturn]] void dieSaying(const char* cause);

}  // namespace muelle::grader::worker

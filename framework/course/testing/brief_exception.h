#pragma once
#include <exception>

namespace muelle {

/// Inside a handler: lets the exception go on; one whose text is longer than anybody reads as a std::runtime_error with
/// the beginning of that text. Who catches it next (GoogleTest) copies the text many times over: a hundred megabytes
/// would become more than the program may have, and the crash would hide what was thrown.
[[noreturn]] void rethrowBriefly(const std::exception& error);

}  // namespace muelle

#pragma once
#include <string>

namespace muelle::grader {

/// What a finding of a sanitizer means to the student, to follow the name of the function that was called.
/// \param finding AddressSanitizer's name of the error, "heap-buffer-overflow", or "missing-return FILE:LINE"
std::string findingText(const std::string& finding);

}  // namespace muelle::grader

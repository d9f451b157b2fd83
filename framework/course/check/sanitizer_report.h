#pragma once
#include "course/check/diagnostics.h"
#include "course/check/outcome.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// What a finding of a sanitizer means, to follow the name of a function or the line of a file; "" when it is none that
/// is known. \param finding AddressSanitizer's name of the error, or the line that holds it
std::string_view sanitizerSentence(std::string_view finding);

/// The class of what a sanitizer reports, where it confirms what the second look is made for: memory that is gone or
/// not theirs, a missing return. Outcome::Passed where it does not: stack and memory that have run out are no misuse,
/// because the sanitizers themselves take more of both. \param finding as above
Outcome confirmedOutcome(std::string_view finding);

/// What the second look has confirmed.
struct SanitizerFinding {
  std::string sentence;  ///< names the line: "spring_3d.cpp:26 reads a variable that is gone"; "" when nothing
  Outcome outcome = Outcome::Passed;
};

/// What the sanitizers of the second build have confirmed in a student's file.
/// \param output what the sanitised program wrote to standard error
SanitizerFinding explainSanitizers(std::string_view output, const std::vector<StudentFile>& files);

}  // namespace muelle

#pragma once
#include "course/check/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// What a finding of a sanitizer means, to follow the name of a function or the line of a file; "" when it is none that
/// is known. \param finding AddressSanitizer's name of the error, or the line that holds it
std::string_view sanitizerSentence(std::string_view finding);

/// What the sanitizers of the second build have confirmed, in a sentence that names the line: "spring_3d.cpp:26 reads a
/// variable that is gone"; "" when they found nothing in a student's file.
/// \param output what the sanitised program wrote to standard error
std::string explainSanitizers(std::string_view output, const std::vector<StudentFile>& files);

}  // namespace muelle

#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace muelle::grader {

/// What in a source explains a wrong number, with its line.
struct SourceClue {
  int line = 0;          ///< from 1
  std::string function;  ///< in whose body it stands; "" of one that is sought in the whole file
  std::string token;
};

/// A division of two whole numbers, or a sum of `accumulate` that starts from one, in the body of a function or of one
/// that it calls.
std::optional<SourceClue> integerDivision(std::string_view source, std::string_view function);

/// A variable of whole numbers that is given a number with a fraction, in the body of a function or of one that it
/// calls.
std::optional<SourceClue> wholeVariable(std::string_view source, std::string_view function);

/// The first `float`, or literal with an f at its end, of the file.
std::optional<SourceClue> singlePrecision(std::string_view source);

}  // namespace muelle::grader

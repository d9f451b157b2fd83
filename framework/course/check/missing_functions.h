#pragma once
/// \file
/// Functions of the contract that a file lacks, or has as something else (static, inline, other argument types): what
/// needs them fails, and the others are judged.

#include "course/check/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// In the place of an asserting function's name: the assertion is a call of a function that is missing, its condition
/// the sentence about it.
inline constexpr std::string_view missingFunction = "(missing)";

/// The file that defines them is compiled under this name.
inline constexpr const char* missingSourceName = "muelle_missing.cpp";

/// The functions of the contract that the linker misses; none where it complains of anything else.
std::vector<std::string> missingFunctions(std::string_view linkerText, std::string_view contract);

/// "springForceOnB is missing: spring_1d.cpp:12 is inline: nothing outside the file can call it; remove inline"
std::string missingSentence(const std::string& function, const std::vector<StudentFile>& files,
                            std::string_view contract, std::string_view contractName);

/// A source that defines them: a call ends as an assertion does, with the sentence.
std::string missingSource(const std::vector<std::string>& functions, const std::vector<StudentFile>& files,
                          std::string_view contract, std::string_view contractName);

/// The functions that the contract has declared and the file makes static; none where GCC has any other error.
std::vector<std::string> staticFunctions(std::string_view compilerWords, const std::vector<StudentFile>& files);

}  // namespace muelle

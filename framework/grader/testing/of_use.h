#pragma once
/// \file
/// The anchor of a law: a function that gives zero, a constant or no number keeps many laws, and has earned none.
///
///     MUELLE_EXPECT_OF_USE(springForce);
///
/// The anchor of an edge, which a general mistake does not cost, not even an argument left out everywhere:
///
///     MUELLE_EXPECT_ANSWERS(springForce);

#include "grader/verdict.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace muelle::grader {

/// For MUELLE_EXPECT_OF_USE: asks the student's function at its registered arguments (MUELLE_ARGUMENTS).
::testing::AssertionResult isOfUse(const char* text, const std::string& function);

/// For MUELLE_EXPECT_ANSWERS: the same, but an argument may be left out.
::testing::AssertionResult givesAnswers(const char* text, const std::string& function);

/// What may be built on a student's function.
enum class Use {
  Good,     ///< it is of use, or shows one named mistake
  None,     ///< zero, constant, no number, stateful, without one of its arguments: nothing is earned by it
  Missing,  ///< it gives no answer at all
};

/// Asks a function at its registered arguments. Nothing else may have been asked of it before.
Use useToOthers(const std::string& function, std::uint64_t seed);

/// Each function that a criterion follows and that no MUELLE_ARGUMENTS are registered for, in a line that names the
/// manifest.
std::vector<std::string> withoutArguments(const Manifest& manifest, const std::string& manifestName);

}  // namespace muelle::grader

#define MUELLE_EXPECT_OF_USE(function) EXPECT_PRED_FORMAT1(::muelle::grader::isOfUse, std::string(#function))
#define MUELLE_EXPECT_ANSWERS(function) EXPECT_PRED_FORMAT1(::muelle::grader::givesAnswers, std::string(#function))

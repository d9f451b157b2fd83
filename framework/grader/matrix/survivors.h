#pragma once
#include "grader/matrix/mutation.h"

#include <filesystem>

namespace muelle::grader {

/// A mutation of a solution that no test can tell from it, and why.
struct Survivor {
  std::string lineText;  ///< the solution's line, trimmed
  std::string mutation;  ///< "< -> <="
  int occurrence = 1;    ///< which one of that token, in the lines of that text
  std::string reason;

  bool matches(const Mutation& mutation) const;
};

/// What an exercise's mutants.toml says.
struct Survivors {
  std::vector<Survivor> listed;
  /// Why any other mutation may survive, "" when none may. For an exercise whose answer is free (tests that the student
  /// writes), where a mutation that no test objects to is another right answer.
  std::string any;
};

/// Reads tests/submissions/TOPIC/mutants.toml:
///
///     any = "another right test"    # may be left out
///
///     [[survivor]]
///     line = "if (depth <= 0.0) return Vec3::Zero();"
///     mutation = "<= -> <"
///     occurrence = 1            # the first `<=` of the lines of this text; may be left out
///     reason = "at depth 0 both branches give zero"
///
/// No file, no survivors. Throws std::runtime_error with file, line and key.
/// \param shown the file's name in messages
Survivors readSurvivors(const std::filesystem::path& file, const std::string& shown);

/// The entry to paste for a mutation that survives, without its reason.
std::string survivorEntry(const Mutation& mutation);

}  // namespace muelle::grader

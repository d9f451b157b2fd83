#pragma once
#include "course/check/outcome.h"
#include "grader/run/keys.h"
#include "grader/sandbox/sandbox.h"

#include <string>

namespace muelle::grader {

/// What `check` says of a submission.
struct Checked {
  Outcome outcome = Outcome::Passed;
  std::string words;    ///< for a failure of the test
  std::string trouble;  ///< why there is no outcome; "" when there is
};

/// Checks the files in the sandbox: no network, nothing to write to but a scratch folder, bounded memory. It sees the
/// course and what was built of it where they are, as a student's machine has them, and /proc, which AddressSanitizer
/// reads.
/// \param sandbox bubblewrap: the weaker ones cannot give a program these paths
Checked checkConfined(const Sandbox& sandbox, const Manifest& manifest, const Sources& sources);

}  // namespace muelle::grader

#pragma once
#include "course/manifest.h"

#include <set>
#include <string>

namespace muelle::grader {

/// What a submission of tests/submissions/ must get: the first line of a wrong one states it.
struct Expectation {
  std::set<std::string> lost;   ///< suites that must fail; every other one must pass
  std::set<std::string> named;  ///< ids of which the grader must name at least one, and no other; empty: none
  bool noPoints = false;        ///< `loses: all`: not even partial credit
};

/// Full marks and nothing to name: right submissions and the solution.
Expectation fullMarks();

/// Not a point and nothing to name: the stub.
Expectation noPoints(const Manifest& manifest);

/// Reads `// loses: SuiteA, SuiteB; misconception: idA or idB` (or `loses: all`, `misconception: none`), the first line
/// of `source`. Throws std::runtime_error that begins with `shown`:1 when the line is malformed or names a suite or a
/// misconception that neither the manifest nor generic_ids.h has.
/// \param shown the file's name in messages
Expectation readExpectation(const std::string& source, const std::string& shown, const Manifest& manifest);

}  // namespace muelle::grader

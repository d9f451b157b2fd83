#pragma once
#include <string>
#include <vector>

namespace muelle::hard_cases {

/// A case as cases.json describes it.
struct CaseFacts {
  std::string id;       ///< "H04"
  std::string name;     ///< "elastic_pendulum"
  std::string correct;  ///< what a right answer looks like, in words
  std::string how;      ///< where the reference values come from
};

/// All cases, in the order of the file. Throws std::runtime_error when cases.json cannot be read.
const std::vector<CaseFacts>& allCases();

/// A reference value of cases.json, rounded to double: reference("H04", "regular.t10.x1").
/// Throws std::out_of_range naming what is missing.
double reference(const std::string& id, const std::string& name);
/// The same as the decimal string of the file, with all its digits.
const std::string& referenceText(const std::string& id, const std::string& name);
/// The names of a case's references.
std::vector<std::string> referenceNames(const std::string& id);

}  // namespace muelle::hard_cases

#pragma once
#include "grader/report/explanation.h"

#include <string>
#include <vector>

namespace muelle::grader {

/// One thing to mend: a named mistake, or what the code did (a crash, a time-out), and what it costs. Printable text.
struct Mending {
  std::string says;
  std::string hint;                   ///< may be ""
  std::string example;                ///< a call to check on paper; may be ""
  bool isNamed = false;               ///< a mistake whose numbers match; else a fault
  std::vector<std::string> criteria;  ///< names of those that it costs, in the manifest's order
  double points = 0.0;                ///< what these have lost together
};

/// What a student has to mend in an exercise, each thing once, that which costs most first. Criteria that are lost and
/// explained by nothing are in none.
std::vector<Mending> mendingsOf(const GradedExercise& exercise);

/// What a student reads of an exercise before anything else, a few lines at most: why it was not graded, or the
/// commonest things to mend, or the criteria that do not pass when nothing else is known. None when all is well.
std::vector<std::string> firstLines(const GradedExercise& exercise);

}  // namespace muelle::grader

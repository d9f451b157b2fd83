#pragma once
#include "course/manifest.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// One hidden test of a criterion.
struct TestOutcome {
  std::string name;      ///< "FollowsHookesLaw"
  std::string property;  ///< sentence of MUELLE_PROPERTY, or the name
  bool passed = false;
  std::vector<std::string> details;  ///< one line a failed expectation: what was got and expected
  std::string call;                  ///< the latest call before the first failure, as source; "" when none
};

/// A misconception of the manifest that explains every answer of one function.
struct NamedMistake {
  std::string id;
  std::string function;
  bool operator==(const NamedMistake&) const = default;
};

/// What the test process wrote for one criterion: the only thing that earns points.
struct Verdict {
  std::string topic;
  std::string suite;
  std::vector<TestOutcome> tests;
  std::vector<NamedMistake> misconceptions;  ///< those whose numbers match exactly
  std::string fault;  ///< what the student's code did (crash, time-out, forbidden call ...), one line; "" when nothing
  std::string graderFault;  ///< what went wrong on our side; not empty: no score, run again
  std::string output;       ///< what the student's code printed, cut
  double seconds = 0.0;
  long calls = 0;

  /// True when every test passed and nothing else went wrong. An empty list of tests is not a pass.
  bool passed() const;
};

/// How one hand-in of one exercise got to its worker.
struct BuildOutcome {
  enum class Status { Built, Missing, Refused, CompileError, GraderFault };
  Status status = Status::Missing;
  std::string message;      ///< one line: what happened
  std::string diagnostics;  ///< the compiler's words, cut to the student's own lines
};

/// One exercise of a graded submission.
struct GradedExercise {
  Manifest manifest;
  BuildOutcome build;
  std::map<std::string, Verdict> verdicts;  ///< by suite; a criterion without one scores 0
  std::vector<std::string> figures;         ///< SVG texts: the student's curves over the reference
  std::string figuresNote;                  ///< why there are no figures; "" when there are
};

/// Everything the report shows.
struct GradedSubmission {
  std::string name;                       ///< the folder's or archive's name; untrusted text
  std::vector<std::string> intakeNotes;   ///< what was ignored or refused; untrusted text inside
  std::vector<GradedExercise> exercises;  ///< in course order
  std::string sandbox;                    ///< "bubblewrap", or what weaker backend was used and why
  std::string date;                       ///< ISO 8601, UTC
  double seconds = 0.0;
};

/// Points of one criterion: from the manifest and the record alone. nullopt when the grader is at fault.
std::optional<double> score(const Criterion& criterion, const GradedExercise& exercise);
/// Sum over the criteria; a criterion with the grader at fault counts nothing (and hasGraderFault() says so).
double score(const GradedExercise& exercise);
double score(const GradedSubmission& submission);
double maxScore(const GradedSubmission& submission);
bool hasGraderFault(const GradedSubmission& submission);

/// Feedback for one criterion at the manifest's level, most important line first: misconception, fault, property,
/// values.
std::vector<std::string> feedback(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader

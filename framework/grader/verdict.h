#pragma once
#include "course/check/outcome.h"
#include "course/manifest.h"
#include "course/testing/mismatch.h"
#include "grader/evidence.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// A mistake that a test has seen at work (grader/testing/seen.h); of no function: none.
struct SeenMistake {
  std::string function;
  std::string id;  ///< of the manifest
  bool operator==(const SeenMistake&) const = default;
};

/// One hidden test of a criterion.
struct TestOutcome {
  std::string name;      ///< "FollowsHookesLaw"
  std::string property;  ///< sentence of MUELLE_PROPERTY, or the name
  bool passed = false;
  std::vector<Mismatch> mismatches;  ///< the failed expectations, the first few of them
  std::string call;                  ///< the latest call before the first failure, as source; "" when none
  SeenMistake seen = {};             ///< of which function the test has said that it has seen a mistake, if any
};

/// A mistake that explains every answer of one function, in all criteria.
struct NamedMistake {
  std::string id;        ///< of the manifest, or of generic_mistakes.h
  std::string function;  ///< that shows it
  std::string says;      ///< first line of the feedback
  std::string hint;      ///< how to mend it; may be ""
  bool operator==(const NamedMistake&) const = default;
};

/// A call that a student can check on paper: the simplest found that shows the same mistake.
struct CounterExample {
  std::string function;
  std::vector<std::string> arguments;  ///< each as source
  std::vector<double> got;             ///< result, then out-parameters
  std::vector<double> expected;
  bool isVerdict = false;  ///< the function answers true or false, not a number
  bool operator==(const CounterExample&) const = default;
};

/// What the test process wrote for one criterion: the only thing that earns points.
struct Verdict {
  std::string topic;
  std::string suite;
  Outcome outcome = Outcome::Wrong;  ///< Killed and Wall are the machine's word: no score
  std::vector<TestOutcome> tests;
  std::vector<CounterExample> examples;  ///< one of each function that has answered wrongly
  Evidence evidence;                     ///< what the calls say, for nameMistakes()
  std::vector<NamedMistake> mistakes;    ///< named by the pool, over all criteria: not part of the record
  std::string fault;  ///< what the student's code did (crash, time-out, forbidden call ...), one line; "" when nothing
  bool isConfirmed = false;  ///< the fault is a sanitizer's finding, of the kinds that the second look is made for
  std::string graderFault;   ///< what went wrong on our side; not empty: no score, run again
  std::string neverWritten;  ///< the first function that returned memory to which nothing was written, or ""
  std::string timedOut;      ///< the function in which time ran out, Session::loading, or ""
  std::string output;        ///< what the student's code printed, cut
  /// The lower functions with which the criterion was earned although it failed as it is: the record is then that of
  /// the run with the reference's, or with values computed from the student's own.
  std::vector<std::string> followed;
  double seconds = 0.0;
  long calls = 0;

  /// True when the record says so, every test passed and nothing else went wrong. An empty list of tests is not a pass.
  bool passed() const;
};

/// How one hand-in of one exercise got to its worker.
struct BuildOutcome {
  enum class Status { Built, Missing, Refused, CompileError, GraderFault };
  Status status = Status::Missing;
  std::string message;                 ///< one line: what happened
  std::string diagnostics;             ///< the compiler's words, cut to the student's own lines
  Outcome outcome = Outcome::Refused;  ///< as `check` names it; of no meaning when Built or GraderFault
};

/// One exercise of a graded submission.
struct GradedExercise {
  Manifest manifest;
  BuildOutcome build;
  std::string note;  ///< how the file was taken, when not under its own name; "" when it was; untrusted text inside
  std::map<std::string, Verdict> verdicts;  ///< by suite; in a built exercise, a criterion without one has no score
  std::vector<std::string> figures;         ///< SVG texts: the student's curves over the reference
  std::string figuresNote;                  ///< why there are no figures; "" when there are
  std::uint64_t seed = 0;                   ///< of the inputs of its tests; 0: none were asked
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

/// What the grader did wrong for one criterion, in one line; "" when nothing. In a built exercise that is also a record
/// that is missing, that belongs elsewhere or that holds no test, and one of a run that was ended from outside.
std::string graderFault(const Criterion& criterion, const GradedExercise& exercise);

/// Points of one criterion: from the manifest and the record alone. nullopt when the grader is at fault.
std::optional<double> score(const Criterion& criterion, const GradedExercise& exercise);
/// Sum over the criteria; a criterion with the grader at fault counts nothing (and hasGraderFault() says so).
double score(const GradedExercise& exercise);
double score(const GradedSubmission& submission);
double maxScore(const GradedSubmission& submission);
bool hasGraderFault(const GradedExercise& exercise);
bool hasGraderFault(const GradedSubmission& submission);

/// Feedback for one criterion at the manifest's level, most important line first: memory that was never written,
/// misconception, fault, property, values.
std::vector<std::string> feedback(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader

#pragma once
#include "grader/intake/intake.h"
#include "grader/run/workplace.h"
#include "grader/sandbox/sandbox.h"

#include <map>
#include <string>

namespace muelle::grader {

/// The files that were handed in for one exercise: name -> content.
using Sources = std::map<std::string, std::string>;

/// How a submission is graded.
struct GradeOptions {
  SandboxChoice sandbox = SandboxChoice::Automatic;
  std::string seed;        ///< the instructor's; the inputs of every exercise derive from it
  bool fresh = false;      ///< build and run again although a verdict is kept
  bool withCurves = true;  ///< draw the demo's curves
  /// The same inputs for every hand-in, and records that hold what authors compare: no grading of students.
  bool forAuthors = false;
};

/// Names everything that a compiled hand-in is made of: the exercise, its files, contract, harness, glue, flags,
/// compiler, sandbox. Equal keys, equal objects.
std::string objectKey(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                      SandboxChoice sandbox);

/// Names everything that a verdict depends on: the object, the test program, the criterion's entry, host, seed.
std::string verdictKey(const Workplace& workplace, const Manifest& manifest, const Criterion& criterion,
                       const std::string& objectKey, const GradeOptions& options);

/// The same for the curves.
std::string curvesKey(const Workplace& workplace, const Manifest& manifest, const std::string& objectKey,
                      const GradeOptions& options);

/// The inputs of an exercise follow from the instructor's seed and the files alone: another hand-in gets other numbers,
/// the same hand-in the same ones on every machine. For authors they follow from the seed alone.
std::uint64_t inputSeed(const Manifest& manifest, const Sources& sources, const GradeOptions& options);

/// The instructor's seed kept in the build folder; made at random on first use. Two that start at once agree on one.
std::string keptSeed(const Workplace& workplace);

}  // namespace muelle::grader

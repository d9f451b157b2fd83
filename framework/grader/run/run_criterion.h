#pragma once
#include "grader/run/build_worker.h"

namespace muelle::grader {

/// How a submission is graded.
struct GradeOptions {
  SandboxChoice sandbox = SandboxChoice::Automatic;
  std::string seed;    ///< the instructor's; the inputs of every exercise derive from it
  bool fresh = false;  ///< build and run again although a verdict is kept
};

/// Names everything that a verdict depends on: worker, test program, manifest's entry, seed, sandbox.
std::string verdictKey(const Workplace& workplace, const Manifest& manifest, const std::string& suite,
                       const std::string& workerKey, const GradeOptions& options);

/// The same for the curves.
std::string curvesKey(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                      const GradeOptions& options);

/// The latest record under that key, a fault of the grader included; nullopt when nothing has run.
std::optional<Verdict> writtenVerdict(const Workplace& workplace, const std::string& key);

/// Removes the record and the curves of that key.
void forgetVerdict(const Workplace& workplace, const std::string& key);

/// The verdict that need not be found again: a record without a fault of the grader.
std::optional<Verdict> keptVerdict(const Workplace& workplace, const std::string& key);

/// Runs one criterion's hidden tests against a built worker in a process of their own, unless the verdict is kept, and
/// returns its record. A missing or unreadable record is the grader's fault.
Verdict runCriterion(const Workplace& workplace, const Manifest& manifest, const Criterion& criterion,
                     const std::string& workerKey, const GradeOptions& options);

/// The curves of the exercise's demo: student's over reference.
struct Curves {
  std::vector<std::string> svgs;
  std::string note;  ///< why there are none
};

/// Draws them, unless they are kept.
Curves drawCurves(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                  const GradeOptions& options);

/// The kept curves; nullopt when they have not been drawn.
std::optional<Curves> keptCurves(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                                 const GradeOptions& options);

}  // namespace muelle::grader

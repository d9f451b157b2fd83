#pragma once
#include "grader/run/build_worker.h"
#include "grader/run/keys.h"
#include "grader/run/store.h"
#include "grader/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// One hand-in of one exercise, built and ready to be judged.
struct Candidate {
  const Manifest& manifest;
  const Sources& sources;
  std::string objectKey;
  BuiltObject object;
};

/// Where candidates are judged and what is found is kept.
struct JudgingPlace {
  const Workplace& workplace;
  const Store& objects;
  const Store& records;
  const Sandbox& sandbox;
};

/// The verdict that need not be found again: a record without a fault of ours or the machine's.
std::optional<Verdict> keptVerdict(const Workplace& workplace, const Store& store, const Candidate& candidate,
                                   const Criterion& criterion, const GradeOptions& options);

/// Runs one criterion's hidden tests in a process of their own and returns its record; keeps it when it is certain.
/// A missing or unreadable record is our fault. After the second look (when the candidate has a sanitised object) the
/// verdict is the worse of both; where it depends on the fill of memory (when there is an object with another), it is
/// Outcome::NeverWritten. One that failed may be earned in spite of a lower function (follow.h).
Verdict judgeCriterion(const JudgingPlace& place, const Candidate& candidate, const Criterion& criterion,
                       const GradeOptions& options);

/// All looks of that, and nothing more. \param ownLower the functions of which given::f is the student's
Verdict lookAtCriterion(const Workplace& workplace, const Candidate& candidate, const Criterion& criterion,
                        const GradeOptions& options, const std::vector<std::string>& ownLower);

/// True for a verdict of a death or a wide limit: to be tried once more, alone.
bool isDoubtful(const Verdict& verdict);

/// True for a doubtful verdict that is the submission's when the second try says the same: a limit of processor time,
/// and a death of which the submission's own process tells, which could hold up a class for ever.
bool isOwnIfTwice(const Verdict& verdict);

/// Keeps a verdict that a second try alone has confirmed.
void keepVerdict(const Workplace& workplace, const Store& store, const Candidate& candidate, const Criterion& criterion,
                 const GradeOptions& options, const Verdict& verdict);

/// The curves of the exercise's demo: student's over reference.
struct Curves {
  std::vector<std::string> svgs;
  std::string note;  ///< why there are none
};

/// Draws them, unless they are kept.
Curves drawCurves(const Workplace& workplace, const Store& store, const Candidate& candidate,
                  const GradeOptions& options);

/// The kept curves; nullopt when they have not been drawn.
std::optional<Curves> keptCurves(const Workplace& workplace, const Store& store, const Candidate& candidate,
                                 const GradeOptions& options);

}  // namespace muelle::grader

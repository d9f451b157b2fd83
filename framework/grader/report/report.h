#pragma once
#include "grader/verdict.h"

#include <filesystem>
#include <string>

namespace muelle::grader {

/// A table for the terminal: exercise, criterion, points, first line of the feedback; whatever the submission holds, a
/// few lines each. `colour` only on a terminal.
std::string terminalTable(const GradedSubmission& graded, bool colour, int width);

/// Gradescope's results.json; without `score` where the grader is at fault.
std::string resultsJson(const GradedSubmission& graded);

/// JUnit XML from the records: not handed in or not compiled = failure, the grader's fault = error. Like results.json,
/// it keeps at most 8 KiB of a text.
std::string junitXml(const GradedSubmission& graded);

/// One self-contained page: every criterion, its feedback, the curves. No script, no outside resource; every text of
/// the submission escaped; a Content-Security-Policy that allows only inline styles and images.
std::string htmlPage(const GradedSubmission& graded);

/// Writes report.html, results.xml (JUnit) and results.json into `folder`, each whole or not at all, the scores last. A
/// link in place of a file is replaced, not followed. Throws std::runtime_error with one line that names the file, and
/// when `folder` is a link that leads out of the folder it stands in.
void writeReports(const GradedSubmission& graded, const std::filesystem::path& folder);

/// Removes these files where they stand: a submission that has no score any more keeps none of an earlier run.
/// Throws std::system_error naming the file that cannot be removed.
void removeReports(const std::filesystem::path& folder);

}  // namespace muelle::grader

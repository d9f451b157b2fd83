#pragma once
#include "grader/verdict.h"

#include <filesystem>
#include <string>

namespace muelle::grader {

/// A table for the terminal: exercise, criterion, points, first line of the feedback. `colour` only on a terminal.
std::string terminalTable(const GradedSubmission& graded, bool colour, int width);

/// Gradescope's results.json.
std::string resultsJson(const GradedSubmission& graded);

/// JUnit XML from the records: not run = failure, the grader's fault = error.
std::string junitXml(const GradedSubmission& graded);

/// One self-contained page: every criterion, its feedback, the curves. No script, no outside resource; every text of
/// the submission escaped; a Content-Security-Policy that allows only inline styles and images.
std::string htmlPage(const GradedSubmission& graded);

/// Writes results.json, results.xml (JUnit) and report.html into `folder`, each whole or not at all.
void writeReports(const GradedSubmission& graded, const std::filesystem::path& folder);

}  // namespace muelle::grader

#pragma once
#include "grader/matrix/matrix.h"

namespace muelle::grader {

/// The kill matrix of one exercise as text: a legend, a row a submission, a column a criterion, then the mutants.
/// `x` lost, `.` passed, `!` beside one that was to be otherwise.
std::string matrixText(const TopicMatrix& matrix);

/// The counts, a line each.
std::string summaryText(const MatrixSummary& summary);

/// One line a row and criterion, one a mutant: topic,kind,name,criterion,expected,observed,misconceptions.
std::string matrixCsv(const std::vector<TopicMatrix>& matrices);

/// Short names of the suites for column heads, at most three letters and all different, in the order of the criteria.
std::vector<std::string> columnCodes(const Manifest& manifest);

}  // namespace muelle::grader

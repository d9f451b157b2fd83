#pragma once
#include "harness/figure.h"
#include "lab/hard_cases/matrix.h"

#include <string>

namespace muelle::hard_cases {

/// The table for a terminal, one row a variant; with colours when asked for.
std::string matrixText(const Matrix& matrix, bool colours);
/// The counts in words, and every cell that failed unexpectedly.
std::string summaryText(const Matrix& matrix);
/// A line for every cell, with its prediction and its work.
std::string matrixCsv(const Matrix& matrix);
/// The page of the documentation.
std::string matrixPage(const Matrix& matrix);
/// The matrix as a table of colours, with the power of ten of each error.
Figure matrixFigure(const Matrix& matrix);

}  // namespace muelle::hard_cases

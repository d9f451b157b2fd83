#pragma once
#include "harness/figure.h"
#include "lab/hard_cases/prediction.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle::hard_cases {

enum class Outcome { Passed, FailedAsPredicted, NotApplicable, FailedUnexpectedly };

/// What became of one method on one variant.
struct Cell {
  std::string method;
  std::size_t variant = 0;  ///< index into the matrix's variants
  std::string setting;      ///< "h = 0.001 s", "tolerance 1e-08"
  Prediction prediction;    ///< made before the run
  Outcome outcome = Outcome::FailedUnexpectedly;
  double error = 0.0;  ///< in the variant's measure; infinite when the run stopped
  std::string note;    ///< what stopped it, or why it is not applicable
  engine::Work work;
  double seconds = 0.0;
};

struct MatrixOptions {
  std::vector<std::string> cases = {};    ///< "H04"; empty: all
  std::vector<std::string> methods = {};  ///< ids; empty: all
  bool longRuns = false;                  ///< H01 in full, and larger budgets
};

struct Matrix {
  std::vector<std::string> methods;
  std::vector<Variant> variants;
  std::vector<Cell> cells;  ///< methods by variants, the variants of a method together

  const Cell& at(std::size_t method, std::size_t variant) const { return cells[method * variants.size() + variant]; }
  int count(Outcome outcome) const;
};

/// Chooses rows and columns; throws std::invalid_argument with the nearest known name.
Matrix planMatrix(const MatrixOptions& options);
/// Runs one method on one variant. Throws nothing: what goes wrong is in the cell.
Cell runCell(const std::string& method, const Variant& variant, const MatrixOptions& options);
/// Runs all cells; `progress` is called with the fraction done.
void runMatrix(Matrix& matrix, const MatrixOptions& options, const std::function<void(double)>& progress);

/// "1e-09", "~ 3e+02", "n/a", "! 0.1": passed, failed as predicted, not applicable, failed unexpectedly.
std::string cellText(const Cell& cell);
/// The table for a terminal, one row a variant; with colours when asked for.
std::string matrixText(const Matrix& matrix, bool colours);
/// The counts in words, and every cell that failed unexpectedly.
std::string summaryText(const Matrix& matrix);
std::string matrixCsv(const Matrix& matrix);
/// The page of the documentation.
std::string matrixPage(const Matrix& matrix);
/// The matrix as a table of colours, with the power of ten of each error.
Figure matrixFigure(const Matrix& matrix);

}  // namespace muelle::hard_cases

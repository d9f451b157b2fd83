#pragma once
#include "lab/hard_cases/prediction.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle::hard_cases {

enum class Outcome { Passed, FailedAsPredicted, NotApplicable, FailedUnexpectedly };

/// A prediction that is off by more than this on the good side is as wrong as one on the bad side: the rule was not the
/// reason.
inline constexpr double surprisinglyGood = 100.0;

/// What became of one method on one variant.
struct Cell {
  std::string method;
  std::size_t variant = 0;  ///< index into the matrix's variants
  std::string setting;      ///< "h = 0.001 s", "tolerance 1e-08"
  Prediction prediction;    ///< made before the run
  Outcome outcome = Outcome::FailedUnexpectedly;
  double error = 0.0;  ///< in the variant's measure; infinite when the run stopped
  std::string note;    ///< what stopped it, or why it is not applicable
  /// The error is more than surprisinglyGood times below the predicted one, whether it passed or not.
  bool betterThanPredicted = false;
  engine::Work work;
  double seconds = 0.0;           ///< [s], with the prediction
  double processorSeconds = 0.0;  ///< [s] of the run alone, whatever else the machine did
};

/// Which rows and columns.
struct MatrixOptions {
  std::vector<std::string> cases = {};    ///< "H04"; empty: all
  std::vector<std::string> methods = {};  ///< ids; empty: all
};

/// Every method on every variant.
struct Matrix {
  std::vector<std::string> methods;
  std::vector<Variant> variants;
  std::vector<Cell> cells;  ///< methods by variants, the variants of a method together

  const Cell& at(std::size_t method, std::size_t variant) const { return cells[method * variants.size() + variant]; }
  int count(Outcome outcome) const;
  int betterThanPredicted() const;
};

/// Chooses rows and columns; throws std::invalid_argument with the nearest known name.
Matrix planMatrix(const MatrixOptions& options);
/// Runs one method on one variant, whose facts are complete (completeFacts()). Throws nothing: what goes wrong is in
/// the cell.
Cell runCell(const std::string& method, const Variant& variant);
/// Runs all cells; `progress` is called with the fraction done.
void runMatrix(Matrix& matrix, const std::function<void(double)>& progress);

/// A cell that is known to do better than its prediction, and why the rules do not foresee it.
struct KnownSurprise {
  std::string variant;  ///< its label
  std::string method;
  std::string reason;
};
/// At most five: more would mean that the rules are wrong.
const std::vector<KnownSurprise>& knownSurprises();
/// The reason of a cell that is better than predicted; empty when there is none.
std::string reasonOf(const Matrix& matrix, const Cell& cell);
/// The cells that are better than predicted for no known reason.
std::vector<const Cell*> unexplained(const Matrix& matrix);

}  // namespace muelle::hard_cases

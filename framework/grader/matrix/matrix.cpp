#include "grader/matrix/matrix.h"

#include <algorithm>

namespace muelle::grader {

bool MatrixRow::isNamedAsStated() const {
  if (kind == Kind::Stub) return true;  // what is handed out answers zero, as it says itself
  return named.empty() == expected.named.empty() && std::ranges::includes(expected.named, named);
}

bool MatrixRow::exact() const {
  if (!trouble.empty() || lost != expected.lost || !isNamedAsStated()) return false;
  return !expected.noPoints || points == 0.0;
}

bool Mutant::asStated() const {
  if (!trouble.empty()) return false;
  return fate == Fate::Survived ? !whySurvives().empty() : reason.empty();
}

bool TopicMatrix::good() const {
  return endsNotPassed.empty() && mistakesNotToldApart.empty() && staleSurvivors.empty() &&
         std::all_of(rows.begin(), rows.end(), [](const MatrixRow& row) { return row.exact(); }) &&
         std::all_of(mutants.begin(), mutants.end(), [](const Mutant& mutant) { return mutant.asStated(); });
}

namespace {

void count(const MatrixRow& row, MatrixSummary& sum) {
  const bool isRight = row.kind == MatrixRow::Kind::Right || row.kind == MatrixRow::Kind::Solution;
  ++sum.rows;
  sum.exactRows += row.exact() ? 1 : 0;
  sum.examples += row.examples;
  sum.examplesForPaper += row.examplesForPaper;
  sum.falseRejections += isRight && !row.lost.empty() ? 1 : 0;
  if (row.expected.named.empty()) return;
  ++sum.misconceptions;
  if (row.isNamedAsStated()) ++sum.named;
  for (const std::string& id : row.named) sum.wronglyNamed += row.expected.named.contains(id) ? 0 : 1;
}

void count(const Mutant& mutant, MatrixSummary& sum) {
  if (!mutant.trouble.empty()) {
    ++sum.troubles;
    return;
  }
  switch (mutant.fate) {
    case Mutant::Fate::Killed:
      ++sum.killed;
      break;
    case Mutant::Fate::NotCompilable:
      ++sum.notCompilable;
      break;
    case Mutant::Fate::Survived:
      ++(mutant.whySurvives().empty() ? sum.survivedWithout : sum.survivedWithReason);
      break;
  }
  if (mutant.fate != Mutant::Fate::Survived && !mutant.reason.empty()) ++sum.staleSurvivors;
}

}  // namespace

MatrixSummary summarise(const std::vector<TopicMatrix>& matrices) {
  MatrixSummary sum;
  for (const TopicMatrix& matrix : matrices) {
    for (const MatrixRow& row : matrix.rows) count(row, sum);
    for (const Mutant& mutant : matrix.mutants) count(mutant, sum);
    sum.staleSurvivors += static_cast<int>(matrix.staleSurvivors.size());
  }
  return sum;
}

}  // namespace muelle::grader

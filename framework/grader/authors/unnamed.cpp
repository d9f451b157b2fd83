#include "grader/authors/unnamed.h"

#include "grader/naming/merged_evidence.h"

#include <algorithm>

namespace muelle::grader {

namespace {

bool isWithoutName(const Verdict& verdict) {
  const bool isSaidOtherwise = verdict.isConfirmed || verdict.outcome == Outcome::NeverWritten;
  return !verdict.passed() && verdict.graderFault.empty() && verdict.mistakes.empty() && !isSaidOtherwise;
}

bool isWrong(const Evidence& evidence, const std::string& function) {
  const auto found = evidence.find(function);
  return found != evidence.end() && found->second.wrong > 0;
}

bool isBuiltOnWrong(const std::string& function, const Manifest& manifest, const Evidence& evidence) {
  return std::ranges::any_of(manifest.criteria, [&](const Criterion& criterion) {
    return std::ranges::find(criterion.functions, function) != criterion.functions.end() &&
           std::ranges::any_of(criterion.follows, [&](const std::string& lower) { return isWrong(evidence, lower); });
  });
}

void add(UnnamedMistake& mistake, const FunctionEvidence& evidence, const Verdict& verdict) {
  mistake.answers.insert(mistake.answers.end(), evidence.answers.begin(), evidence.answers.end());
  const auto shown = std::ranges::find(verdict.examples, mistake.function, &CounterExample::function);
  if (!mistake.example && shown != verdict.examples.end()) mistake.example = *shown;
}

}  // namespace

std::vector<UnnamedMistake> unnamedMistakes(const GradedExercise& exercise) {
  const Evidence all = mergedEvidence(exercise.verdicts);
  std::map<std::string, UnnamedMistake> found;
  for (const auto& [suite, verdict] : exercise.verdicts) {
    if (!isWithoutName(verdict)) continue;
    for (const auto& [function, evidence] : verdict.evidence) {
      const bool isLaidToLower = isBuiltOnWrong(function, exercise.manifest, all);
      if (evidence.wrong == 0 || evidence.isStateful || isLaidToLower) continue;
      add(found.try_emplace(function, UnnamedMistake{function, {}, {}}).first->second, evidence, verdict);
    }
  }
  std::vector<UnnamedMistake> mistakes;
  for (auto& [function, mistake] : found) mistakes.push_back(std::move(mistake));
  return mistakes;
}

}  // namespace muelle::grader

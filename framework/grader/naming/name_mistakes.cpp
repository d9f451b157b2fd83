#include "grader/naming/name_mistakes.h"

#include "course/contract.h"
#include "grader/naming/generic_sentence.h"
#include "grader/naming/merged_evidence.h"
#include "grader/naming/source_clues.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace muelle::grader {

namespace {

/// Names the mistake of one function after the other.
class Namer {
 public:
  Namer(const Manifest& manifest, const Evidence& evidence, std::string_view contract, std::string_view source)
      : manifest_(manifest), evidence_(evidence), contract_(contract), source_(source) {}

  std::optional<NamedMistake> nameOf(const std::string& function) const {
    const FunctionEvidence& evidence = evidence_.at(function);
    if (!evidence.isStateful && evidence.wrong + evidence.imprecise < fewestWrong) return std::nullopt;
    if (evidence.isUnwritten) return std::nullopt;  // that is said, and its numbers are nobody's
    for (const auto way : {&Namer::stateful, &Namer::zeroByDivision, &Namer::listed, &Namer::alwaysTheSame}) {
      if (auto named = (this->*way)(function, evidence)) return named;
    }
    if (restsOnNothing(function)) return std::nullopt;
    for (const auto way : {&Namer::genericExactly, &Namer::wholeNumbers, &Namer::nearlyRight, &Namer::generic,
                           &Namer::notANumber, &Namer::partly}) {
      if (auto named = (this->*way)(function, evidence)) return named;
    }
    return std::nullopt;
  }

 private:
  using Found = std::optional<NamedMistake>;

  bool isOfUse(const std::string& function) const {
    const auto found = evidence_.find(function);
    return found == evidence_.end() || !(isAlwaysZero(found->second) || found->second.isConstant);
  }

  /// Whether it is built on a function that always answers the same: what its answers then look like is no mistake of
  /// its own ("leaves x out").
  bool restsOnNothing(const std::string& function) const {
    return std::ranges::any_of(manifest_.criteria, [&](const Criterion& criterion) {
      return std::ranges::find(criterion.functions, function) != criterion.functions.end() &&
             !std::ranges::all_of(criterion.follows, [&](const std::string& lower) { return isOfUse(lower); });
    });
  }

  /// Answers that are right to some digits, in a good part of all calls: elsewhere round-off may cost digits, too.
  static bool isImprecise(const FunctionEvidence& evidence) {
    return 5 * evidence.imprecise >= evidence.calls && 2 * evidence.wrong <= evidence.calls;
  }

  static bool isAlwaysZero(const FunctionEvidence& evidence) { return evidence.zero == evidence.calls; }

  /// Where the answers are imprecise anyway, a mistake that agrees to six digits alone explains nothing.
  static bool isSure(const Hypothesis& hypothesis, const FunctionEvidence& evidence) {
    return hypothesis.isExact || !isImprecise(evidence);
  }

  Found stateful(const std::string& function, const FunctionEvidence& evidence) const {
    if (!evidence.isStateful) return std::nullopt;
    return NamedMistake{
        "stateful", function,
        fmt::format("{} depends on earlier calls: asked the same again, or first of all, it answers otherwise",
                    function),
        "Take out static and global variables, and give every variable a value in each call."};
  }

  /// 1 / 2 is 0: the line with it says more than any name for zeros.
  Found zeroByDivision(const std::string& function, const FunctionEvidence& evidence) const {
    return isAlwaysZero(evidence) ? wholeNumbers(function, evidence) : std::nullopt;
  }

  Found alwaysTheSame(const std::string& function, const FunctionEvidence& evidence) const {
    if (isAlwaysZero(evidence)) {
      return NamedMistake{"zero", function, fmt::format("{} always gives 0", function),
                          "It may still be as it was handed out, or return before it has computed anything."};
    }
    if (!evidence.isConstant) return std::nullopt;
    return NamedMistake{"constant", function, fmt::format("{} always gives the same answer", function),
                        "The answer must follow from the arguments."};
  }

  /// The manifest's words for a mistake of a function: its own, or those for a lower function that was wrong, too.
  const Misconception* statement(const std::string& id, const std::string& function) const {
    const Misconception* other = nullptr;
    for (const Misconception& known : manifest_.misconceptions) {
      if (known.id != id) continue;
      if (known.function == function) return &known;
      if (other == nullptr) other = &known;
    }
    return other;
  }

  bool wasWrong(const std::string& function) const {
    const auto found = evidence_.find(function);
    return found != evidence_.end() && found->second.wrong > 0;
  }

  Found listed(const std::string& function, const FunctionEvidence& evidence) const {
    if (evidence.wrong < fewestWrong) return std::nullopt;
    std::vector<NamedMistake> all;
    for (const Hypothesis& each : evidence.agreeing) {
      const bool isKnown = std::ranges::any_of(all, [&](const NamedMistake& known) { return known.id == each.id; });
      const Misconception* words = each.isListed ? statement(each.id, function) : nullptr;
      if (isKnown || words == nullptr || !isSure(each, evidence)) continue;
      const bool isOwn = words->function == function || wasWrong(words->function);
      all.push_back({each.id, isOwn ? words->function : function,
                     isOwn ? words->says : fmt::format("in {}, {}", function, words->says), words->hint});
    }
    if (all.empty()) return std::nullopt;
    NamedMistake named = all.front();
    // Two mistakes with the same numbers: the effect is sure, the cause is one of them.
    if (all.size() > 1) named.says = fmt::format("{}; or, with the same numbers, {}", all[0].says, all[1].says);
    return named;
  }

  Found genericExactly(const std::string& function, const FunctionEvidence& evidence) const {
    return firstGeneric(function, evidence, [](const Hypothesis& each) { return each.isExact; });
  }

  Found generic(const std::string& function, const FunctionEvidence& evidence) const {
    return firstGeneric(function, evidence, [&](const Hypothesis& each) { return isSure(each, evidence); });
  }

  template <class Counts>
  Found firstGeneric(const std::string& function, const FunctionEvidence& evidence, const Counts& counts) const {
    if (evidence.wrong < fewestWrong) return std::nullopt;
    const std::vector<Parameter> parameters = parametersOf(contract_, function);
    for (const Hypothesis& each : evidence.agreeing) {
      const std::string says = each.isListed || !counts(each) ? "" : sentenceOf(each, function, parameters);
      if (!says.empty()) return NamedMistake{each.id, function, says, ""};
    }
    return std::nullopt;
  }

  Found notANumber(const std::string& function, const FunctionEvidence& evidence) const {
    if (evidence.notANumber < fewestWrong || evidence.notANumber != evidence.wrong) return std::nullopt;
    const Separation found = separationOf(evidence, parametersOf(contract_, function));
    const std::string where =
        found.id.empty() ? fmt::format("in {} of {} calls", evidence.wrong, evidence.calls) : "where " + found.where;
    return NamedMistake{"missing_guard", function,
                        fmt::format("{} gives no finite number {}, and is right elsewhere", function, where),
                        "Look for a division by zero or the root of a negative number there."};
  }

  /// Right to some digits where it is right at all: single precision, a difference quotient, a rounded constant.
  Found nearlyRight(const std::string& function, const FunctionEvidence& evidence) const {
    if (evidence.imprecise < fewestWrong || !isImprecise(evidence)) return std::nullopt;
    const int digits = static_cast<int>(-std::log10(evidence.worstNear));
    const std::string says = fmt::format("{} is right to about {} digits only", function, digits);
    if (const auto clue = singlePrecision(source_)) {
      return NamedMistake{"single_precision", function,
                          fmt::format("{}: line {} computes with {}", says, clue->line, clue->token),
                          "Compute with double everywhere: it has 16 digits."};
    }
    return NamedMistake{"difference_quotient", function,
                        says + ": a derivative by differences, a sum that stops early, or a rounded constant",
                        "Derivatives are asked for as formulas, which are exact; constants with all their digits."};
  }

  Found wholeNumbers(const std::string& function, const FunctionEvidence& evidence) const {
    if (const auto clue = evidence.wrong < fewestWrong ? std::nullopt : wholeVariable(source_, function)) {
      return NamedMistake{"whole_numbers", function,
                          fmt::format("line {}, {}: {} keeps whole numbers only, and is given one with a fraction",
                                      clue->line, clue->function, clue->token),
                          "Declare it as double."};
    }
    const auto clue = integerDivision(source_, function);
    if (!clue) return std::nullopt;
    return NamedMistake{"integer_division", function,
                        fmt::format("line {}, {}: {} computes with whole numbers, which have no fractions", clue->line,
                                    clue->function, clue->token),
                        "Write 1.0 / 2 or 0.5, and start a sum with 0.0."};
  }

  /// Right in one part of the arguments' range, wrong in the other.
  Found partly(const std::string& function, const FunctionEvidence& evidence) const {
    if (evidence.wrong < fewestWrong) return std::nullopt;
    const Separation found = separationOf(evidence, parametersOf(contract_, function));
    if (found.id.empty()) return std::nullopt;
    const char* what = evidence.wrongZero == evidence.wrong ? "gives 0" : "is wrong";
    return NamedMistake{found.id, function,
                        fmt::format("{} {} where {}, and is right elsewhere", function, what, found.where), ""};
  }

  const Manifest& manifest_;
  const Evidence& evidence_;
  std::string_view contract_;
  std::string_view source_;
};

/// In the manifest's order: a function that others are made of stands first.
std::vector<std::string> functionsOf(const Manifest& manifest, const Evidence& evidence) {
  std::vector<std::string> functions;
  const auto add = [&](const std::string& function) {
    const bool isNew = std::ranges::find(functions, function) == functions.end();
    if (isNew && evidence.contains(function)) functions.push_back(function);
  };
  for (const Criterion& criterion : manifest.criteria) std::ranges::for_each(criterion.functions, add);
  for (const auto& [function, each] : evidence) add(function);
  return functions;
}

bool isLostBy(const Verdict& verdict, const std::string& function) {
  const auto found = verdict.evidence.find(function);
  return found != verdict.evidence.end() &&
         (found->second.isStateful || found->second.wrong + found->second.imprecise > 0);
}

bool mayBeNamed(const Verdict& verdict) {
  return !verdict.passed() && verdict.graderFault.empty() && !verdict.isConfirmed;
}

void addUnlessSaid(std::vector<NamedMistake>& mistakes, const NamedMistake& named) {
  const bool isSaid =
      std::ranges::any_of(mistakes, [&](const NamedMistake& known) { return known.says == named.says; });
  if (!isSaid) mistakes.push_back(named);
}

/// What the failed tests of a criterion say that they have seen, in the manifest's words.
void nameSeen(const Manifest& manifest, Verdict& verdict) {
  for (const TestOutcome& test : verdict.tests) {
    const auto words = std::ranges::find_if(manifest.misconceptions, [&](const Misconception& known) {
      return known.id == test.seen.id && known.function == test.seen.function;
    });
    if (test.passed || words == manifest.misconceptions.end()) continue;
    addUnlessSaid(verdict.mistakes, {words->id, words->function, words->says, words->hint});
  }
}

}  // namespace

void nameMistakes(GradedExercise& exercise, std::string_view contract, std::string_view source) {
  const Evidence evidence = mergedEvidence(exercise.verdicts);
  const Namer namer(exercise.manifest, evidence, contract, source);
  for (const std::string& function : functionsOf(exercise.manifest, evidence)) {
    const std::optional<NamedMistake> named = namer.nameOf(function);
    if (!named) continue;
    for (auto& [suite, verdict] : exercise.verdicts) {
      if (!mayBeNamed(verdict) || !isLostBy(verdict, function)) continue;
      addUnlessSaid(verdict.mistakes, *named);
    }
  }
  for (auto& [suite, verdict] : exercise.verdicts) {
    if (mayBeNamed(verdict)) nameSeen(exercise.manifest, verdict);
  }
}

}  // namespace muelle::grader

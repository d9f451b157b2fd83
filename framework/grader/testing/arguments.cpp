#include "grader/testing/arguments.h"

#include "base/text/trim.h"
#include "base/text/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>

namespace muelle::grader {

namespace {

bool areFinite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool isZero(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return number == 0; });
}

bool allAnswersAreFinite(const Examination& examination) {
  return std::ranges::all_of(examination.draws, [](const Answers& answers) { return areFinite(answers.own); }) &&
         std::ranges::all_of(examination.exchanged,
                             [](const auto& exchanged) { return areFinite(exchanged.answers.own); });
}

bool answersAreRepeated(const Examination& examination) {
  for (std::size_t i = 0; i < examination.draws.size(); ++i) {
    if (examination.draws[i].own != examination.again[i]) return false;
  }
  return true;
}

/// All draws get one answer.
bool isConstant(const std::vector<Answers>& draws, std::vector<double> Answers::*whose) {
  return std::ranges::all_of(draws,
                             [&](const Answers& answers) { return agree(answers.*whose, draws.front().*whose, 0.0); });
}

/// The place of the first argument that changes the oracle's answer and never the student's; nothing when there is
/// none. One answer that stays is no proof: a rope does not push, whatever k is.
std::optional<std::size_t> ignoredArgument(const Examination& examination) {
  std::map<std::size_t, bool> isIgnored;
  for (const Examination::Exchanged& exchanged : examination.exchanged) {
    const Answers& before = examination.draws[exchanged.draw];
    if (agree(before.right, exchanged.answers.right, 0.0)) continue;
    bool& soFar = isIgnored.try_emplace(exchanged.argument, true).first->second;
    soFar = soFar && agree(before.own, exchanged.answers.own, 0.0);
  }
  const auto found = std::ranges::find_if(isIgnored, [](const auto& argument) { return argument.second; });
  return found == isIgnored.end() ? std::nullopt : std::optional(found->first);
}

std::string shownArgument(const std::vector<std::string>& names, std::size_t place) {
  const bool hasName = place < names.size() && !names[place].empty();
  return hasName ? names[place] : fmt::format("argument {}", place + 1);
}

/// The text between the parenthesis at `open` and the one that closes it, cut at the commas that are not inside others.
std::vector<std::string> partsInside(const std::string& text, std::size_t open) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (std::size_t i = open + 1; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(' || c == '{' || c == '[') ++depth;
    if (c == ')' || c == '}' || c == ']') --depth;
    if (depth < 0) break;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace

Uselessness judgeUse(const Examination& examination, const std::string& function,
                     const std::vector<std::string>& arguments) {
  if (!allAnswersAreFinite(examination)) return {function + " gives no number", false};
  if (!answersAreRepeated(examination)) return {function + " gives another answer when asked again", false};
  const bool mayBeConstant = isConstant(examination.draws, &Answers::right);
  if (!mayBeConstant && isConstant(examination.draws, &Answers::own)) {
    const bool isNothing = isZero(examination.draws.front().own);
    return {fmt::format("{} gives {} always", function, isNothing ? "zero" : "the same"), false};
  }
  const std::optional<std::size_t> ignored = ignoredArgument(examination);
  if (!ignored) return {};
  return {fmt::format("{} gives the same whatever {} is", function, shownArgument(arguments, *ignored)), true};
}

std::vector<std::string> namesInTuple(const std::string& generator) {
  const std::size_t tuple = generator.rfind("tuple");
  const std::size_t open = tuple == std::string::npos ? tuple : generator.find_first_of("({", tuple);
  if (open == std::string::npos) return {};
  std::vector<std::string> names;
  for (const std::string& part : partsInside(generator, open)) {
    const std::string name(trimmed(part));
    names.push_back(std::ranges::all_of(name, isNameCharacter) ? name : "");
  }
  return names;
}

std::map<std::string, GeneralPosition>& GeneralPosition::all() {
  static std::map<std::string, GeneralPosition> all;
  return all;
}

void registerGeneralPosition(const CallHistoryBase& history, const char* function, const GeneralPosition::Draw& draw,
                             const char* source) {
  GeneralPosition::all().try_emplace(function, history, function, draw, namesInTuple(source));
}

Answers GeneralPosition::ask(const UntypedArguments& arguments) const {
  return {history_.askSubmission(arguments), history_.askOracle(arguments)};
}

Uselessness GeneralPosition::examine(Random random) const {
  constexpr std::size_t drawCount = 6;
  std::vector<UntypedArguments> draws;
  for (std::size_t i = 0; i < drawCount; ++i) draws.push_back(draw_(random));
  Examination examination;
  for (const UntypedArguments& draw : draws) examination.draws.push_back(ask(draw));
  for (std::size_t argument = 0; argument < draws.front().list.size(); ++argument) {
    for (std::size_t i = 0; i < drawCount; ++i) {
      const UntypedArguments mixed = history_.copied(draws[i]);
      const Argument& exchanged = mixed.list[argument];
      exchanged.kind->assign(exchanged.value, draws[(i + 1) % drawCount].list[argument].value);
      examination.exchanged.push_back({argument, i, ask(mixed)});
    }
  }
  examination.again.resize(drawCount);
  for (std::size_t i = drawCount; i-- > 0;) examination.again[i] = ask(draws[i]).own;
  return judgeUse(examination, function_, names_);
}

}  // namespace muelle::grader

#include "grader/authors/mistake_text.h"

#include "base/text/count.h"
#include "base/text/lists.h"
#include "base/text/printable.h"
#include "base/text/trim.h"
#include "course/check/source_tokens.h"
#include "course/contract.h"
#include "grader/naming/function_text.h"
#include "grader/report/example_sentence.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

constexpr int mostLines = 60;
constexpr std::size_t mostBytes = 4000;

/// In the hidden tests the contract's functions are the oracle's.
std::string callingOracle(std::string_view body, const std::vector<std::string>& functions) {
  const std::vector<std::string_view> tokens = sourceTokens(body);
  std::string text;
  std::size_t done = 0;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool isCall = tokens[i + 1] == "(" && std::ranges::find(functions, tokens[i]) != functions.end();
    if (!isCall || (i > 0 && (tokens[i - 1] == ":" || tokens[i - 1] == "."))) continue;
    const auto at = static_cast<std::size_t>(tokens[i].data() - body.data());
    text += fmt::format("{}oracle::", body.substr(done, at - done));
    done = at;
  }
  return text + std::string(body.substr(done));
}

std::string oracleCall(const std::string& function, std::string_view contract) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parametersOf(contract, function)) names.push_back(parameter.name);
  return fmt::format("\n  return oracle::{}({});  // with the mistake in it\n", function, joined(names, ", "));
}

std::string lambda(const UnnamedGroup& group, std::string_view contract) {
  const std::string& function = group.mistake.function;
  const DeclarationText declared = declarationText(contract, function).value_or(DeclarationText{"auto", ""});
  const std::optional<FunctionText> own = functionText(group.source, function);
  const std::string body = own ? callingOracle(own->body, functionsOf(contract)) : oracleCall(function, contract);
  const std::string_view parameters = own ? own->parameters : declared.parameters;
  return fmt::format("[]({}) -> {} {{{}}}", trimmed(parameters), declared.result, body);
}

std::string names(const std::vector<std::string>& handIns) {
  std::vector<std::string> printable;
  for (const std::string& each : handIns) printable.push_back(printableLine(each));
  return joined(printable, ", ");
}

}  // namespace

std::string mistakeText(const UnnamedGroup& group, std::string_view contract) {
  const std::string& function = group.mistake.function;
  const std::string registered = fmt::format("MUELLE_MISTAKE({}, some_id, {});", function, lambda(group, contract));
  const std::string entry = fmt::format(
      "[[misconception]]\nid = \"some_id\"\nfunction = \"{}\"\nsays = \"what the student did\"\n"
      "hint = \"how to mend it\"",
      function);
  return fmt::format("  tests/hidden/{0}/mistakes.cpp:\n\n{1}\n\n  exercises/{0}/exercise.toml:\n\n{2}\n", group.topic,
                     cutText(printableText(registered), mostLines, mostBytes), entry);
}

std::string groupText(const UnnamedGroup& group, std::string_view contract) {
  const std::string& function = group.mistake.function;
  const bool isOne = group.handIns.size() == 1;
  std::string text =
      fmt::format("{} of {} {} in {}, without a name: {}\n", counted(static_cast<int>(group.handIns.size()), "hand-in"),
                  group.topic, isOne ? "is wrong" : "are wrong alike", function, names(group.handIns));
  if (group.mistake.example) text += "  " + printableLine(exampleSentence(*group.mistake.example)) + "\n";
  return text + mistakeText(group, contract);
}

}  // namespace muelle::grader

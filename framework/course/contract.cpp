#include "course/contract.h"

#include "base/text/lists.h"
#include "base/text/trim.h"
#include "base/text/words.h"
#include "course/check/source_tokens.h"

#include <fmt/format.h>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace muelle {

namespace {

using Tokens = std::vector<std::string_view>;

/// The tokens between "(" at `open` and its ")", split at the commas that stand in no bracket of their own.
std::vector<Tokens> argumentsAt(const Tokens& tokens, std::size_t open) {
  std::vector<Tokens> arguments(1);
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const std::string_view token = tokens[i];
    if (token == ")" && depth == 1) break;
    if (token == "(" || token == "<") ++depth;
    if (token == ")" || token == ">") --depth;
    if (i == open) continue;
    if (token == "," && depth == 1) {
      arguments.emplace_back();
    } else {
      arguments.back().push_back(token);
    }
  }
  if (arguments.size() == 1 && arguments.front().empty()) arguments.clear();
  return arguments;
}

/// By struct: the names that MUELLE_STRUCT gives its fields.
std::map<std::string_view, std::vector<std::string>> structsIn(const Tokens& tokens) {
  std::map<std::string_view, std::vector<std::string>> structs;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i] != "MUELLE_STRUCT" || tokens[i + 1] != "(") continue;
    const std::vector<Tokens> arguments = argumentsAt(tokens, i + 1);
    for (std::size_t field = 1; field < arguments.size(); ++field) {
      if (!arguments[field].empty()) structs[arguments.front().front()].emplace_back(arguments[field].front());
    }
  }
  return structs;
}

double numberOf(const Tokens& tokens, const std::string& name) {
  const std::string text = joined(tokens, "");
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') {
    throw std::runtime_error(fmt::format("MUELLE_RANGE({}, ...): '{}' is no number", name, text));
  }
  return number;
}

}  // namespace

std::vector<Parameter> parametersOf(std::string_view contract, std::string_view function) {
  const Tokens tokens = sourceTokens(contract);
  const auto structs = structsIn(tokens);
  std::vector<Parameter> parameters;
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    // A declaration has its type before the name; MUELLE_FUNCTIONS(f) and a mention have not.
    if (tokens[i] != function || tokens[i + 1] != "(") continue;
    for (const Tokens& each : argumentsAt(tokens, i + 1)) {
      Parameter parameter;
      for (const std::string_view& token : each) {
        if (const auto known = structs.find(token); known != structs.end()) parameter.fields = known->second;
        if (&token != &each.back()) parameter.type += std::string(token) + ' ';
      }
      if (!each.empty()) parameter.name = std::string(each.back());
      parameter.type = std::string(trimmed(parameter.type));
      parameters.push_back(std::move(parameter));
    }
    break;
  }
  return parameters;
}

std::vector<Range> rangesOf(std::string_view contract) {
  const Tokens tokens = sourceTokens(contract);
  std::vector<Range> ranges;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i] != "MUELLE_RANGE" || tokens[i + 1] != "(") continue;
    const std::vector<Tokens> arguments = argumentsAt(tokens, i + 1);
    if (arguments.size() != 3) throw std::runtime_error("MUELLE_RANGE has a name, the least and the most");
    const std::string name = joined(arguments[0], "");
    ranges.push_back({name, numberOf(arguments[1], name), numberOf(arguments[2], name)});
  }
  return ranges;
}

std::vector<std::string> functionsOf(std::string_view contract) {
  const Tokens tokens = sourceTokens(contract);
  std::vector<std::string> functions;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i] != "MUELLE_FUNCTIONS" || tokens[i + 1] != "(") continue;
    for (const Tokens& each : argumentsAt(tokens, i + 1)) functions.push_back(joined(each, ""));
  }
  return functions;
}

}  // namespace muelle

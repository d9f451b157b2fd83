#include "grader/naming/function_text.h"

#include "base/text/trim.h"
#include "course/check/source_tokens.h"

namespace muelle::grader {

namespace {

using Tokens = std::vector<std::string_view>;

/// The place of what closes the bracket at `open`, the tokens' size when nothing does.
std::size_t closing(const Tokens& tokens, std::size_t open, std::string_view opens, std::string_view closes) {
  int depth = 0;
  for (std::size_t at = open; at < tokens.size(); ++at) {
    if (tokens[at] == opens) ++depth;
    if (tokens[at] == closes && --depth == 0) return at;
  }
  return tokens.size();
}

/// What stands between two tokens of one source.
std::string_view between(std::string_view first, std::string_view last) {
  const char* begin = first.data() + first.size();
  return {begin, static_cast<std::size_t>(last.data() - begin)};
}

}  // namespace

std::optional<FunctionText> functionText(std::string_view source, std::string_view function) {
  const Tokens tokens = sourceTokens(source);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i] != function || tokens[i + 1] != "(") continue;
    const std::size_t close = closing(tokens, i + 1, "(", ")");
    if (close + 1 >= tokens.size() || tokens[close + 1] != "{") continue;
    const std::size_t end = closing(tokens, close + 1, "{", "}");
    if (end == tokens.size()) continue;
    return FunctionText{between(tokens[i + 1], tokens[close]), between(tokens[close + 1], tokens[end])};
  }
  return std::nullopt;
}

std::optional<DeclarationText> declarationText(std::string_view contract, std::string_view function) {
  const Tokens tokens = sourceTokens(contract);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i] != function || tokens[i + 1] != "(") continue;
    const std::size_t close = closing(tokens, i + 1, "(", ")");
    const auto name = static_cast<std::size_t>(tokens[i].data() - contract.data());
    const std::size_t line = contract.rfind('\n', name) + 1;  // npos + 1 is the beginning
    const std::string_view result = trimmed(contract.substr(line, name - line));
    if (!result.empty() && close < tokens.size()) return DeclarationText{result, between(tokens[i + 1], tokens[close])};
  }
  return std::nullopt;
}

}  // namespace muelle::grader

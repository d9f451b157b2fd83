#include "grader/matrix/parameters.h"

namespace muelle::grader {

namespace {

/// Index of the bracket that closes the one at `open`, or the number of tokens.
std::size_t closing(const std::vector<Token>& tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "(" || text == "{" || text == "[") ++depth;
    if ((text == ")" || text == "}" || text == "]") && --depth == 0) return i;
  }
  return tokens.size();
}

bool isTypeWord(std::string_view text) {
  return text == "double" || text == "int" || text == "bool" || text == "const" || text == "void";
}

/// One parameter, tokens [begin, end): the last identifier is its name when a type stands before it.
void addParameter(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
                  std::map<std::string, std::string>& parameters) {
  if (end < begin + 2) return;
  const Token& name = tokens[end - 1];
  if (name.kind != Token::Kind::Identifier || isTypeWord(name.text)) return;
  std::string type;
  for (std::size_t i = begin; i + 1 < end; ++i) type += (type.empty() ? "" : " ") + std::string(tokens[i].text);
  parameters[std::string(name.text)] = type;
}

std::map<std::string, std::string> parametersBetween(const std::vector<Token>& tokens, std::size_t open,
                                                     std::size_t close) {
  std::map<std::string, std::string> parameters;
  int depth = 0;
  std::size_t begin = open + 1;
  for (std::size_t i = open + 1; i <= close; ++i) {
    const std::string_view text = tokens[i].text;
    if (i == close || (depth == 0 && text == "," && !tokens[i].inTemplateList)) {
      addParameter(tokens, begin, i, parameters);
      begin = i + 1;
    }
    if (text == "(" || text == "{") ++depth;
    if (text == ")" || text == "}") --depth;
  }
  return parameters;
}

}  // namespace

std::vector<FunctionBody> functionBodies(const std::vector<Token>& tokens) {
  std::vector<FunctionBody> bodies;
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    if (tokens[i].text != "(" || tokens[i - 1].kind != Token::Kind::Identifier) continue;
    const std::size_t close = closing(tokens, i);
    if (close + 1 >= tokens.size() || tokens[close + 1].text != "{") continue;
    const std::size_t end = closing(tokens, close + 1);
    bodies.push_back({parametersBetween(tokens, i, close), close + 1, end});
    i = end;
  }
  return bodies;
}

}  // namespace muelle::grader

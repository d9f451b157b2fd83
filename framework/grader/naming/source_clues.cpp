#include "grader/naming/source_clues.h"

#include "course/check/source_tokens.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <vector>

namespace muelle::grader {

namespace {

using Tokens = std::vector<std::string_view>;

bool isWholeNumber(std::string_view token) {
  return !token.empty() && std::ranges::all_of(token, [](unsigned char c) { return std::isdigit(c) != 0; });
}

int lineOf(std::string_view source, std::string_view token) {
  return 1 + static_cast<int>(std::count(source.data(), token.data(), '\n'));
}

/// Where the closing one of the brackets stands that open at `at`; the end when there is none.
std::size_t closing(const Tokens& tokens, std::size_t at, std::string_view open, std::string_view close) {
  int depth = 0;
  for (; at < tokens.size(); ++at) {
    if (tokens[at] == open) ++depth;
    if (tokens[at] == close && --depth == 0) break;
  }
  return at;
}

/// Parameters and body of a function; empty when the source does not define it.
struct Definition {
  Tokens parameters;
  Tokens body;
};

Definition definitionOf(const Tokens& tokens, std::string_view function) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i] != function || tokens[i + 1] != "(") continue;
    const std::size_t end = closing(tokens, i + 1, "(", ")");
    if (end + 1 >= tokens.size() || tokens[end + 1] != "{") continue;
    const std::size_t last = closing(tokens, end + 1, "{", "}");
    const auto from = [&tokens](std::size_t at) { return tokens.begin() + static_cast<std::ptrdiff_t>(at); };
    return {Tokens(from(i + 2), from(end)), Tokens(from(end + 2), from(last))};
  }
  return {};
}

/// The function's definition, and those of what it calls, that the source holds.
std::vector<Definition> definitionsBelow(const Tokens& tokens, std::string_view function) {
  constexpr std::size_t most = 20;
  std::vector<std::string_view> names{function};
  std::vector<Definition> found;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) {
    found.push_back(definitionOf(tokens, names[i]));
    const Tokens& body = found.back().body;
    for (std::size_t at = 0; at + 1 < body.size(); ++at) {
      if (body[at + 1] == "(" && std::ranges::find(names, body[at]) == names.end()) names.push_back(body[at]);
    }
  }
  return found;
}

/// "1" "/" "2" with no digit or point beside it: 1.0 / 2 is scanned as "1" "." "0".
bool dividesWholeNumbers(const Tokens& body, std::size_t i) {
  if (i == 0 || i + 1 >= body.size() || body[i] != "/") return false;
  const bool startsWhole = isWholeNumber(body[i - 1]) && (i < 2 || body[i - 2] != ".");
  const bool endsWhole = isWholeNumber(body[i + 1]) && (i + 2 >= body.size() || body[i + 2] != ".");
  return startsWhole && endsWhole;
}

/// accumulate(begin, end, 0)
bool sumsWholeNumbers(const Tokens& body, std::size_t i) {
  if (body[i] != "accumulate") return false;
  std::vector<std::string_view> last;
  int depth = 0;
  int commas = 0;
  for (std::size_t at = i + 1; at < body.size(); ++at) {
    if (body[at] == "(") ++depth;
    if (body[at] == ")" && --depth == 0) break;
    if (body[at] == "," && depth == 1) {
      if (++commas == 3) break;
      last.clear();
    } else {
      last.push_back(body[at]);
    }
  }
  return commas >= 2 && last.size() == 1 && isWholeNumber(last.front());
}

bool isOneOf(std::string_view token, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, token) != words.end();
}

/// The names that a function declares as numbers with a fraction, or as vectors of these.
std::vector<std::string_view> fractionalNames(const Definition& definition) {
  std::vector<std::string_view> names;
  for (const Tokens* tokens : {&definition.parameters, &definition.body}) {
    for (std::size_t i = 0; i + 1 < tokens->size(); ++i) {
      if (!isOneOf((*tokens)[i], {"double", "float", "Vec2", "Vec3", "Vec6", "Vec9", "Vector3d"})) continue;
      names.push_back((*tokens)[i + ((*tokens)[i + 1] == "&" && i + 2 < tokens->size() ? 2 : 1)]);
    }
  }
  return names;
}

/// `int rate = ...` from what has a fraction; a cast to a whole number counts as well.
std::optional<std::string_view> cutNumber(const Definition& definition) {
  const Tokens& body = definition.body;
  const std::vector<std::string_view> fractional = fractionalNames(definition);
  const auto hasFraction = [&fractional](std::string_view token) {
    return std::ranges::find(fractional, token) != fractional.end() ||
           isOneOf(token, {"dot", "norm", "stableNorm", "squaredNorm", "sqrt", "hypot", "abs", "fabs", "pow"});
  };
  for (std::size_t i = 0; i + 3 < body.size(); ++i) {
    if (!isOneOf(body[i], {"int", "long", "unsigned", "short"}) || !isOneOf(body[i + 2], {"=", "{"})) continue;
    for (std::size_t at = i + 3; at < body.size() && !isOneOf(body[at], {";", "}", "<", ">"}); ++at) {
      if (isOneOf(body[at], {"size", "rows", "cols"})) break;
      if (hasFraction(body[at])) return body[i];
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<SourceClue> integerDivision(std::string_view source, std::string_view function) {
  for (const Definition& definition : definitionsBelow(sourceTokens(source), function)) {
    const Tokens& body = definition.body;
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (dividesWholeNumbers(body, i)) {
        const std::string_view all(
            body[i - 1].data(), static_cast<std::size_t>(body[i + 1].data() + body[i + 1].size() - body[i - 1].data()));
        return SourceClue{"integer_division", lineOf(source, body[i]), std::string(all)};
      }
      if (sumsWholeNumbers(body, i)) {
        return SourceClue{"integer_division", lineOf(source, body[i]), "accumulate(..., 0)"};
      }
    }
  }
  return std::nullopt;
}

std::optional<SourceClue> wholeVariable(std::string_view source, std::string_view function) {
  for (const Definition& definition : definitionsBelow(sourceTokens(source), function)) {
    if (const auto type = cutNumber(definition)) {
      return SourceClue{"whole_numbers", lineOf(source, *type), std::string(*type)};
    }
  }
  return std::nullopt;
}

std::optional<SourceClue> singlePrecision(std::string_view source) {
  for (const std::string_view token : sourceTokens(source)) {
    const bool isType = token == "float" || token == "Vector3f" || token == "Vector2f" || token == "VectorXf" ||
                        token == "fabsf" || token == "sqrtf";
    if (isType) return SourceClue{"single_precision", lineOf(source, token), std::string(token)};
  }
  return std::nullopt;
}

}  // namespace muelle::grader

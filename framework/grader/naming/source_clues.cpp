#include "grader/naming/source_clues.h"

#include "base/text/words.h"
#include "course/check/source_tokens.h"
#include "grader/naming/function_text.h"

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

/// Parameters and body of a function.
struct Definition {
  std::string_view name;
  Tokens parameters;
  Tokens body;
};

/// The function's definition, and those of what it calls, that the source holds.
std::vector<Definition> definitionsBelow(std::string_view source, std::string_view function) {
  constexpr std::size_t most = 20;
  std::vector<std::string_view> names{function};
  std::vector<Definition> found;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) {
    const std::optional<FunctionText> text = functionText(source, names[i]);
    if (!text) continue;
    found.push_back({names[i], sourceTokens(text->parameters), sourceTokens(text->body)});
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
      const std::string_view name = (*tokens)[i + ((*tokens)[i + 1] == "&" && i + 2 < tokens->size() ? 2 : 1)];
      if (isNameCharacter(name.front())) names.push_back(name);  // not the colon of Vec3::Zero()
    }
  }
  return names;
}

/// Whether a word with a fraction stands between `at` and the end of the statement; what counts has none.
bool takesFraction(const Tokens& body, std::size_t at, const std::vector<std::string_view>& fractional) {
  for (; at < body.size() && !isOneOf(body[at], {";", "}", "<", ">", "size", "rows", "cols"}); ++at) {
    const bool isField = at > 0 && body[at - 1] == ".";  // of the same name, perhaps
    if ((!isField && std::ranges::find(fractional, body[at]) != fractional.end()) ||
        isOneOf(body[at], {"dot", "norm", "stableNorm", "squaredNorm", "sqrt", "hypot", "abs", "fabs", "pow"}))
      return true;
  }
  return false;
}

/// `int rate = ...`, or later `rate = ...` and `rate += ...`, from what has a fraction.
std::optional<std::string_view> cutNumber(const Definition& definition) {
  const Tokens& body = definition.body;
  const std::vector<std::string_view> fractional = fractionalNames(definition);
  std::vector<std::string_view> whole;
  for (std::size_t i = 0; i + 3 < body.size(); ++i) {
    if (isOneOf(body[i], {"int", "long", "unsigned", "short"}) && isOneOf(body[i + 2], {"=", "{"})) {
      whole.push_back(body[i + 1]);
      if (takesFraction(body, i + 3, fractional)) return body[i + 1];
    }
    const bool isWhole = std::ranges::find(whole, body[i]) != whole.end();
    const bool isAdded = isOneOf(body[i + 1], {"+", "-", "*"}) && body[i + 2] == "=";
    const bool isSet = body[i + 1] == "=" && body[i + 2] != "=";
    if (isWhole && (isSet || isAdded) && takesFraction(body, i + 2, fractional)) return body[i];
  }
  return std::nullopt;
}

SourceClue clue(std::string_view source, const Definition& definition, std::string_view at, std::string_view token) {
  return {lineOf(source, at), std::string(definition.name), std::string(token)};
}

}  // namespace

std::optional<SourceClue> integerDivision(std::string_view source, std::string_view function) {
  for (const Definition& definition : definitionsBelow(source, function)) {
    const Tokens& body = definition.body;
    for (std::size_t i = 0; i < body.size(); ++i) {
      if (sumsWholeNumbers(body, i)) return clue(source, definition, body[i], "accumulate(..., 0)");
      if (!dividesWholeNumbers(body, i)) continue;
      const char* end = body[i + 1].data() + body[i + 1].size();
      return clue(source, definition, body[i], {body[i - 1].data(), end});
    }
  }
  return std::nullopt;
}

std::optional<SourceClue> wholeVariable(std::string_view source, std::string_view function) {
  for (const Definition& definition : definitionsBelow(source, function)) {
    if (const auto name = cutNumber(definition)) return clue(source, definition, *name, *name);
  }
  return std::nullopt;
}

std::optional<SourceClue> singlePrecision(std::string_view source) {
  for (const std::string_view token : sourceTokens(source)) {
    const bool isType = token == "float" || token == "Vector3f" || token == "Vector2f" || token == "VectorXf" ||
                        token == "fabsf" || token == "sqrtf";
    if (isType) return SourceClue{lineOf(source, token), "", std::string(token)};
  }
  return std::nullopt;
}

}  // namespace muelle::grader

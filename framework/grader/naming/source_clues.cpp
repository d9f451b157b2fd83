#include "grader/naming/source_clues.h"

#include "course/check/source_tokens.h"
#include "grader/naming/function_text.h"

#include <algorithm>
#include <cctype>
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

/// The tokens of the function's body; empty when the source does not define it.
Tokens bodyOf(std::string_view source, std::string_view function) {
  const std::optional<FunctionText> text = functionText(source, function);
  return text ? sourceTokens(text->body) : Tokens();
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

}  // namespace

std::optional<SourceClue> integerDivision(std::string_view source, std::string_view function) {
  const Tokens body = bodyOf(source, function);
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (dividesWholeNumbers(body, i)) {
      const std::string_view all(
          body[i - 1].data(), static_cast<std::size_t>(body[i + 1].data() + body[i + 1].size() - body[i - 1].data()));
      return SourceClue{"integer_division", lineOf(source, body[i]), std::string(all)};
    }
    if (sumsWholeNumbers(body, i)) return SourceClue{"integer_division", lineOf(source, body[i]), "accumulate(..., 0)"};
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

#include "grader/authoring/withheld.h"

#include "base/file.h"
#include "course/contract.h"
#include "course/manifest.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

// Below these weights people who know nothing of each other write the same.
constexpr std::size_t leastWeight = 14;       // -k * (L - L0) has 14
constexpr std::size_t leastShapeWeight = 17;  // whatever the names are
constexpr std::size_t leastBodyWeight = 40;   // as long as four short lines
constexpr std::size_t shortestSentence = 32;  // [bytes]

bool isArithmetic(std::string_view token) {
  static const std::set<std::string_view> operators = {"+", "-", "*", "/", "+=", "-=", "*=", "/="};
  return operators.contains(token);
}

using Tokens = std::vector<Token>;

/// The name of a variable: neither called, nor a member, nor part of a qualified name.
bool isVariable(const Tokens& tokens, std::size_t i) {
  if (tokens[i].kind != Token::Kind::Identifier) return false;
  const auto isOneOf = [&](std::size_t at, std::initializer_list<std::string_view> texts) {
    return at < tokens.size() && std::ranges::find(texts, tokens[at].text) != texts.end();
  };
  return !isOneOf(i + 1, {"(", "::"}) && !(i > 0 && isOneOf(i - 1, {".", "::", "->"}));
}

/// Where the value of a statement begins: after its first `return`, `=`, `+=` or `-=`; else the statement.
std::size_t beginOfValue(const Tokens& tokens, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "return" || text == "=" || text == "+=" || text == "-=") return i + 1;
  }
  return begin;
}

Expression expressionOf(const Tokens& tokens, std::size_t begin, std::size_t end) {
  Expression expression;
  std::map<std::string_view, std::size_t> places;
  expression.offset = tokens[begin].offset;
  for (std::size_t i = begin; i < end; ++i) {
    const std::string_view text = tokens[i].text;
    expression.weight += isArithmetic(text) ? 3 : 1;
    expression.plain += fmt::format("{} ", text);
    if (isVariable(tokens, i)) {
      expression.shape += fmt::format("${} ", places.emplace(text, places.size()).first->second);
    } else {
      expression.shape += fmt::format("{} ", text);
    }
  }
  return expression;
}

/// Where the brace closes that opens at `open`; the number of tokens when none does.
std::size_t closingBrace(const Tokens& tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    if (tokens[i].text == "{") ++depth;
    if (tokens[i].text == "}" && --depth == 0) return i;
  }
  return tokens.size();
}

bool opensBody(const Tokens& tokens, std::size_t i) {
  if (tokens[i].text != "{" || i == 0) return false;
  return tokens[i - 1].text == ")" || (tokens[i - 1].text == "const" && i > 1 && tokens[i - 2].text == ")");
}

/// \param action takes a file and its tokens
template <class Action>
void forEachSource(const fs::path& folder, const Action& action) {
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (!entry.is_regular_file() || (extension != ".cpp" && extension != ".h")) continue;
    const std::string text = readFile(entry.path());
    action(entry.path(), tokenise(text));
  }
}

/// Reads one checkout into a Withheld.
class Reader {
 public:
  explicit Reader(const fs::path& checkout) : checkout_(checkout) {}

  Withheld read() {
    for (const Manifest& exercise : readCourse(checkout_ / "exercises")) {
      takeContract(exercise.topic);
      forEachSource(checkout_ / "tests/submissions" / exercise.topic / "right",
                    [this](const fs::path& file, const Tokens& tokens) { takeAnswers(shown(file), tokens); });
    }
    forEachSource(checkout_ / "solutions", [this](const fs::path& file, const Tokens& tokens) {
      takeAnswers(shown(file), tokens);
      takeBodies(shown(file), tokens);
      takeNumbers(shown(file), tokens);
    });
    forEachSource(checkout_ / "tests/hidden", [this](const fs::path& file, const Tokens& tokens) {
      takeNumbers(shown(file), tokens);
      takeSentences(shown(file), tokens);
    });
    for (const char* room : {"framework/engine", "framework/lab", "framework/grader"}) {
      forEachSource(checkout_ / room,
                    [this](const fs::path& file, const Tokens& tokens) { takeTypes(shown(file), tokens); });
    }
    return std::move(withheld_);
  }

 private:
  std::string shown(const fs::path& file) const { return file.lexically_relative(checkout_).generic_string(); }

  void takeContract(const std::string& topic) {
    const std::string contract = readFile(checkout_ / "exercises" / topic / (topic + ".h"));
    for (const std::string& function : functionsOf(contract)) {
      withheld_.functions.emplace(function, fmt::format("exercises/{0}/{0}.cpp", topic));
    }
  }

  void takeAnswers(const std::string& file, const Tokens& tokens) {
    for (const Expression& expression : expressionsOf(tokens)) {
      if (expression.weight >= leastWeight) withheld_.plain.emplace(expression.plain, file);
      if (expression.weight >= leastShapeWeight) withheld_.shapes.emplace(expression.shape, file);
    }
  }

  void takeBodies(const std::string& file, const Tokens& tokens) {
    for (const Expression& body : bodiesOf(tokens)) withheld_.bodies.emplace(body.shape, file);
  }

  void takeNumbers(const std::string& file, const Tokens& tokens) {
    for (const Token& token : tokens) {
      if (token.kind == Token::Kind::Number && isOwnNumber(token.text)) {
        withheld_.numbers.emplace(std::string(token.text), file);
      }
    }
  }

  void takeSentences(const std::string& file, const Tokens& tokens) {
    for (const Token& token : tokens) {
      if (token.kind != Token::Kind::Literal || token.text.size() < shortestSentence + 2) continue;
      withheld_.sentences.emplace(std::string(token.text.substr(1, token.text.size() - 2)), file);
    }
  }

  void takeTypes(const std::string& file, const Tokens& tokens) {
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      const bool isDeclared = tokens[i].text == "class" || tokens[i].text == "struct";
      const std::string name(tokens[i + 1].text);
      const bool isOfTwoWords = std::ranges::count_if(name, [](char c) { return c >= 'A' && c <= 'Z'; }) > 1;
      if (isDeclared && isOfTwoWords && tokens[i + 1].kind == Token::Kind::Identifier) {
        withheld_.types.emplace(name, file);
      }
    }
  }

  fs::path checkout_;
  Withheld withheld_;
};

}  // namespace

std::vector<Expression> expressionsOf(const Tokens& tokens) {
  std::vector<Expression> expressions;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= tokens.size(); ++i) {
    const bool isEnd = i == tokens.size() || tokens[i].text == ";" || tokens[i].text == "{" || tokens[i].text == "}";
    if (!isEnd) continue;
    const std::size_t value = beginOfValue(tokens, begin, i);
    const auto arithmetic = std::count_if(tokens.begin() + static_cast<std::ptrdiff_t>(value),
                                          tokens.begin() + static_cast<std::ptrdiff_t>(i),
                                          [](const Token& token) { return isArithmetic(token.text); });
    if (value < i && arithmetic >= 2) expressions.push_back(expressionOf(tokens, value, i));
    begin = i + 1;
  }
  return expressions;
}

std::vector<Expression> bodiesOf(const Tokens& tokens) {
  std::vector<Expression> bodies;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!opensBody(tokens, i)) continue;
    const std::size_t end = closingBrace(tokens, i);
    if (end == i + 1) continue;
    if (const Expression body = expressionOf(tokens, i + 1, end); body.weight >= leastBodyWeight)
      bodies.push_back(body);
    i = end;
  }
  return bodies;
}

bool isOwnNumber(std::string_view number) {
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos) return false;
  std::string digits;
  for (const char c : number) {
    if (c == 'e' || c == 'E') break;
    if (isDigit(c)) digits += c;
  }
  const std::size_t first = digits.find_first_not_of('0');
  const std::size_t last = digits.find_last_not_of('0');
  return first != std::string::npos && last - first + 1 >= 4;
}

Withheld readWithheld(const fs::path& checkout) { return Reader(checkout).read(); }

}  // namespace muelle::grader

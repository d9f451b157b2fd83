#include "grader/matrix/mutation.h"

#include "grader/matrix/parameters.h"
#include "grader/matrix/token.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>

namespace muelle::grader {

namespace {

using Replacements = std::vector<std::string>;

const std::map<std::string_view, Replacements> operatorReplacements{
    {"+", {"-"}},        {"*", {"/"}},        {"/", {"*"}},        {"%", {"*", "/"}}, {"+=", {"-=", "="}},
    {"-=", {"+=", "="}}, {"*=", {"/=", "="}}, {"/=", {"*=", "="}}, {"++", {"--"}},    {"--", {"++"}},
    {"&&", {"||"}},      {"||", {"&&"}},      {"!", {""}}};

constexpr std::array<std::string_view, 6> comparisons{"<", "<=", ">", ">=", "==", "!="};

const std::map<std::string_view, std::string> nameReplacements{
    {"min", "max"},   {"max", "min"},          {"floor", "ceil"},       {"ceil", "floor"}, {"sin", "cos"},
    {"cos", "sin"},   {"norm", "squaredNorm"}, {"squaredNorm", "norm"}, {"head", "tail"},  {"tail", "head"},
    {"Zero", "Ones"}, {"true", "false"},       {"false", "true"}};

/// After one of these a minus is a sign.
bool opensOperand(const Token& token) {
  if (token.kind == Token::Kind::Operator) return token.text != ")" && token.text != "]" && token.text != "}";
  return token.text == "return" || token.text == "case";
}

bool isZero(std::string_view number) { return number == "0" || number == "0.0" || number == "0." || number == ".0"; }

/// Shortest text that reads back as a floating-point literal.
std::string floatingPoint(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

Replacements numberReplacements(std::string_view text) {
  const bool isFloating = text.find_first_of(".eE") != std::string_view::npos;
  if (!isFloating) {
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};  // hexadecimal, suffixes
    if (value == 0) return {"1"};
    return {std::to_string(value + 1), std::to_string(value - 1)};
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  if (value == 0.0) return {"1.0"};
  return {floatingPoint(2.0 * value), floatingPoint(0.5 * value)};
}

/// Finds the mutations of one source.
class Mutator {
 public:
  explicit Mutator(const std::string& source) : source_(source), tokens_(tokenise(source)) {
    bodies_ = functionBodies(tokens_);
  }

  std::vector<Mutation> find() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].text == "using" || tokens_[i].text == "namespace") i = endOfUsing(i);
      if (i < tokens_.size() && !tokens_[i].inTemplateList) mutate(i);
    }
    return std::move(found_);
  }

 private:
  /// A using-declaration ends at its semicolon, a namespace's head at its brace.
  std::size_t endOfUsing(std::size_t i) const {
    while (i < tokens_.size() && tokens_[i].text != ";" && tokens_[i].text != "{") ++i;
    return i;
  }

  void mutate(std::size_t i) {
    switch (tokens_[i].kind) {
      case Token::Kind::Number:
        for (const std::string& number : numberReplacements(tokens_[i].text)) add(i, number);
        break;
      case Token::Kind::Operator:
        mutateOperator(i);
        break;
      case Token::Kind::Identifier:
        mutateName(i);
        break;
      case Token::Kind::Literal:
        break;
    }
  }

  void mutateOperator(std::size_t i) {
    const std::string_view text = tokens_[i].text;
    const bool isUnary = i == 0 || opensOperand(tokens_[i - 1]);
    if (text == "-") add(i, isUnary ? "" : "+");
    if (text == "=") addMinusAfter(i);
    if (isUnary && text != "!" && text != "++" && text != "--") return;  // dereference
    if (text == "*" && isDeclarator(i)) return;
    if (text == "&&" && !tokens_[i].spaceBefore) return;  // auto&& x
    if (const auto replacements = operatorReplacements.find(text); replacements != operatorReplacements.end()) {
      for (const std::string& replacement : replacements->second) add(i, replacement);
    }
    if (std::find(comparisons.begin(), comparisons.end(), text) == comparisons.end()) return;
    for (const std::string_view other : comparisons) {
      if (other != text) add(i, std::string(other));
    }
  }

  /// `double* p`: touches the type; a product has blanks around it.
  bool isDeclarator(std::size_t i) const { return !tokens_[i].spaceBefore; }

  void mutateName(std::size_t i) {
    const std::string_view text = tokens_[i].text;
    if (text == "return") addMinusAfter(i);
    if (text == "abs" || text == "fabs" || text == "sqrt") dropFunction(i);
    const auto replacement = nameReplacements.find(text);
    if (replacement != nameReplacements.end() && isCallOrConstant(i)) add(i, replacement->second);
    swapParameter(i);
  }

  bool isCallOrConstant(std::size_t i) const {
    if (tokens_[i].text == "true" || tokens_[i].text == "false") return true;
    return i + 1 < tokens_.size() && (tokens_[i + 1].text == "(" || tokens_[i + 1].inTemplateList);
  }

  /// `return` -> `return -`, `=` -> `= -`.
  void addMinusAfter(std::size_t i) {
    if (i + 2 >= tokens_.size() || (i > 0 && tokens_[i - 1].text == "[")) return;  // [=] of a lambda
    const Token& next = tokens_[i + 1];
    if (next.text == "-" || next.text == ";" || next.text == "{" || next.text == "[" || next.text == "!") return;
    if (next.text == "true" || next.text == "false" || isZeroValue(i + 1)) return;
    add(i, std::string(tokens_[i].text) + " -");
  }

  /// `0.0;`, `Vec3::Zero();`, `VecX::Zero(n);`
  bool isZeroValue(std::size_t i) const {
    if (isZero(tokens_[i].text)) return tokens_[i + 1].text == ";";
    std::size_t end = i;
    while (end < tokens_.size() && tokens_[end].text != ";") ++end;
    for (std::size_t j = i; j < end; ++j) {
      if (tokens_[j].text != "Zero" || j + 1 >= end || tokens_[j + 1].text != "(") continue;
      const bool plainPath =
          std::all_of(tokens_.begin() + static_cast<std::ptrdiff_t>(i),
                      tokens_.begin() + static_cast<std::ptrdiff_t>(j), [](const Token& token) {
                        return token.kind == Token::Kind::Identifier || token.text == "::" || token.inTemplateList;
                      });
      return plainPath && tokens_[end - 1].text == ")";
    }
    return false;
  }

  /// std::abs(x) -> (x). The qualifier goes with the name.
  void dropFunction(std::size_t i) {
    if (i + 1 >= tokens_.size() || tokens_[i + 1].text != "(") return;
    if (i > 0 && (tokens_[i - 1].text == "." || tokens_[i - 1].text == "->")) return;
    const bool qualified = i >= 2 && tokens_[i - 1].text == "::" && tokens_[i - 2].text == "std";
    const std::size_t first = qualified ? i - 2 : i;
    addSpan(tokens_[first].offset, tokens_[i].offset + tokens_[i].text.size() - tokens_[first].offset, "");
  }

  void swapParameter(std::size_t i) {
    const std::string name(tokens_[i].text);
    if (i > 0 && (tokens_[i - 1].text == "." || tokens_[i - 1].text == "->" || tokens_[i - 1].text == "::")) return;
    for (const FunctionBody& body : bodies_) {
      if (i < body.begin || i > body.end || !body.parameters.contains(name)) continue;
      const std::string& type = body.parameters.at(name);
      for (const auto& [other, otherType] : body.parameters) {
        if (other != name && otherType == type) add(i, other);
      }
    }
  }

  void add(std::size_t i, const std::string& replacement) {
    addSpan(tokens_[i].offset, tokens_[i].text.size(), replacement);
  }

  void addSpan(std::size_t offset, std::size_t length, const std::string& replacement) {
    Mutation mutation;
    mutation.offset = offset;
    mutation.old = source_.substr(offset, length);
    mutation.replacement = replacement;
    locate(mutation);
    found_.push_back(std::move(mutation));
  }

  void locate(Mutation& mutation) {
    const std::size_t before = source_.rfind('\n', mutation.offset);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t end = std::min(source_.find('\n', begin), source_.size());
    mutation.line =
        1 + static_cast<int>(std::count(source_.begin(), source_.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    mutation.column = 1 + static_cast<int>(mutation.offset - begin);
    const std::size_t first = source_.find_first_not_of(" \t", begin);
    mutation.lineText = source_.substr(first, source_.find_last_not_of(" \t\r", end - 1) - first + 1);
    std::set<std::size_t>& places = places_[{mutation.lineText, mutation.old}];
    places.insert(mutation.offset);
    mutation.occurrence = static_cast<int>(places.size());  // mutations are found in the order of the file
  }

  const std::string& source_;
  std::vector<Token> tokens_;
  std::vector<FunctionBody> bodies_;
  std::vector<Mutation> found_;
  std::map<std::pair<std::string, std::string>, std::set<std::size_t>> places_;
};

}  // namespace

std::string Mutation::text() const {
  return fmt::format("{} -> {}", old, replacement.empty() ? "(dropped)" : replacement);
}

std::string Mutation::place() const { return fmt::format("{}:{} {}", line, column, text()); }

std::vector<Mutation> mutations(const std::string& source) { return Mutator(source).find(); }

std::string mutated(const std::string& source, const Mutation& mutation) {
  std::string result = source;
  return result.replace(mutation.offset, mutation.old.size(), mutation.replacement);
}

}  // namespace muelle::grader

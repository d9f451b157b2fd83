#include "grader/matrix/token.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace muelle::grader {

namespace {

bool isNameStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool isName(char c) { return isNameStart(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

constexpr std::array<std::string_view, 24> longOperators{"<<=", ">>=", "...", "->*", "<=>", "::", "->", "++",
                                                         "--",  "+=",  "-=",  "*=",  "/=",  "%=", "&=", "|=",
                                                         "^=",  "==",  "!=",  "<=",  ">=",  "&&", "||", "<<"};

class Scanner {
 public:
  explicit Scanner(std::string_view source) : source_(source) {}

  std::vector<Token> scan() {
    while (position_ < source_.size()) {
      if (skipBlank()) continue;
      if (skipComment()) continue;
      if (skipDirective()) continue;
      take();
    }
    return std::move(tokens_);
  }

 private:
  char at(std::size_t index) const { return index < source_.size() ? source_[index] : '\0'; }
  bool looksAt(std::string_view text) const { return source_.substr(position_, text.size()) == text; }

  bool skipBlank() {
    if (!isSpace(source_[position_])) return false;
    if (source_[position_] == '\n') lineHasToken_ = false;
    ++position_;
    space_ = true;
    return true;
  }

  bool skipComment() {
    if (looksAt("//")) {
      position_ = std::min(source_.find('\n', position_), source_.size());
    } else if (looksAt("/*")) {
      const std::size_t end = source_.find("*/", position_ + 2);
      position_ = end == std::string_view::npos ? source_.size() : end + 2;
    } else {
      return false;
    }
    space_ = true;
    return true;
  }

  /// A line that begins with #, with its continuation lines.
  bool skipDirective() {
    if (source_[position_] != '#' || lineHasToken_) return false;
    while (position_ < source_.size() && (source_[position_] != '\n' || source_[position_ - 1] == '\\')) ++position_;
    return true;
  }

  void take() {
    const std::size_t begin = position_;
    const char c = source_[begin];
    Token::Kind kind = Token::Kind::Operator;
    if (isNameStart(c)) {
      kind = Token::Kind::Identifier;
      while (isName(at(position_))) ++position_;
      if (at(position_) == '"' && at(position_ - 1) == 'R') {
        kind = Token::Kind::Literal;
        passRawText();
      }
    } else if (isDigit(c) || (c == '.' && isDigit(at(begin + 1)))) {
      kind = Token::Kind::Number;
      passNumber();
    } else if (c == '"' || c == '\'') {
      kind = Token::Kind::Literal;
      passQuoted(c);
    } else {
      passOperator();
    }
    tokens_.push_back({kind, source_.substr(begin, position_ - begin), begin, space_, false});
    space_ = false;
    lineHasToken_ = true;
  }

  void passNumber() {
    while (isName(at(position_)) || at(position_) == '.' || at(position_) == '\'' || isSignOfExponent()) ++position_;
  }

  bool isSignOfExponent() const {
    const char before = at(position_ - 1);
    return (at(position_) == '+' || at(position_) == '-') && (before == 'e' || before == 'E');
  }

  void passQuoted(char quote) {
    ++position_;
    while (position_ < source_.size() && source_[position_] != quote) position_ += source_[position_] == '\\' ? 2 : 1;
    position_ = std::min(position_ + 1, source_.size());
  }

  /// At the quote of R"mark( ... )mark".
  void passRawText() {
    const std::size_t open = std::min(source_.find('(', position_), source_.size());
    const std::string end = ")" + std::string(source_.substr(position_ + 1, open - position_ - 1)) + "\"";
    const std::size_t close = source_.find(end, open);
    position_ = close == std::string_view::npos ? source_.size() : close + end.size();
  }

  void passOperator() {
    for (const std::string_view longOperator : longOperators) {
      if (looksAt(longOperator)) {
        position_ += longOperator.size();
        return;
      }
    }
    ++position_;
  }

  std::string_view source_;
  std::vector<Token> tokens_;
  std::size_t position_ = 0;
  bool space_ = false;
  bool lineHasToken_ = false;
};

/// Index of the `>` that closes the list opened at `open`, or 0 when this is no list.
std::size_t closingBracket(const std::vector<Token>& tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "<") ++depth;
    if (text == ">" && --depth == 0) return i;
    if (text == ";" || text == "{" || text == "&&" || text == "||") return 0;
  }
  return 0;
}

void markTemplateLists(std::vector<Token>& tokens) {
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    const bool touchesName = tokens[i - 1].kind == Token::Kind::Identifier && !tokens[i].spaceBefore;
    if (tokens[i].text != "<" || tokens[i].inTemplateList || !(touchesName || tokens[i - 1].text == "template"))
      continue;
    const std::size_t close = closingBracket(tokens, i);
    for (std::size_t j = i; j <= close; ++j) tokens[j].inTemplateList = true;
  }
}

}  // namespace

std::vector<Token> tokenise(std::string_view source) {
  std::vector<Token> tokens = Scanner(source).scan();
  markTemplateLists(tokens);
  return tokens;
}

}  // namespace muelle::grader

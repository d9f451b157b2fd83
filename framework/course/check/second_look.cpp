#include "course/check/second_look.h"

#include "base/text/printable.h"
#include "course/check/filled_flags.h"
#include "course/check/source_tokens.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>

namespace muelle {

namespace {

/// The tokens of a source, of which one may ask beyond the end.
class TokenList {
 public:
  explicit TokenList(std::string_view source) : text_(withoutSplices(source)), tokens_(sourceTokens(text_)) {}
  TokenList(const TokenList&) = delete;  // the tokens are views of the text
  TokenList& operator=(const TokenList&) = delete;

  std::size_t size() const { return tokens_.size(); }
  std::string_view operator[](std::size_t i) const { return i < tokens_.size() ? tokens_[i] : std::string_view(); }
  bool isName(std::size_t i) const {
    const std::string_view token = (*this)[i];
    return !token.empty() && (std::isalpha(static_cast<unsigned char>(token.front())) != 0 || token.front() == '_');
  }
  bool isCall(std::size_t i) const { return (*this)[i] == "(" && i > 0 && (isName(i - 1) || (*this)[i - 1] == ">"); }

  /// Whether one of the tokens from `begin` up to the next semicolon is as asked for.
  template <class Predicate>
  bool untilSemicolon(std::size_t begin, const Predicate& predicate) const {
    for (std::size_t i = begin; i < size() && (*this)[i] != ";"; ++i) {
      if (predicate(i)) return true;
    }
    return false;
  }

 private:
  std::string text_;
  std::vector<std::string_view> tokens_;
};

/// "#pragma GCC diagnostic", "#line 1", "# 1 "x""; #pragma once hides nothing.
bool isHidingDirective(const TokenList& tokens, std::size_t hash) {
  const std::string_view word = tokens[hash + 1];
  if (word == "pragma") return tokens[hash + 2] != "once";
  return word == "line" || (!word.empty() && std::isdigit(static_cast<unsigned char>(word.front())) != 0);
}

/// `auto rest = L0 * ones(n);` keeps references to what ones() returned.
bool isAutoOfTemporaries(const TokenList& tokens, std::size_t i) {
  if (tokens[i] != "auto" || tokens[i + 2] != "=" || tokens[i + 3] == "[") return false;
  const auto isArithmetic = [&](std::size_t j) { return std::string_view("+-*/").find(tokens[j]) < 4; };
  return tokens.untilSemicolon(i + 3, isArithmetic) &&
         tokens.untilSemicolon(i + 3, [&](std::size_t j) { return tokens.isCall(j); });
}

/// `const Vec3& longer(` and `const Vec3& w = longer(a, b)`: what they refer to may be a temporary that is gone.
bool isReferenceFromCall(const TokenList& tokens, std::size_t i) {
  const bool isReference =
      tokens[i] == "&" && i > 0 && (tokens.isName(i - 1) || tokens[i - 1] == ">") && tokens.isName(i + 1);
  if (!isReference || tokens[i - 1] == "return") return false;
  if (tokens[i + 2] == "(") return true;
  return tokens[i + 2] == "=" && tokens.untilSemicolon(i + 3, [&](std::size_t j) { return tokens.isCall(j); });
}

/// `return [&v](double s) ...`
bool isClosureThatLeaves(const TokenList& tokens, std::size_t i) {
  return tokens[i] == "return" && tokens[i + 1] == "[" && tokens[i + 2] == "&";
}

/// A declaration of variables: "double L, best = 0, s[3];". Finds those to which it gives no value.
class Declaration {
 public:
  /// \param begin where a statement begins
  Declaration(const TokenList& tokens, std::size_t begin) : tokens_(tokens), end_(begin) {
    if (!isTyped(begin)) return;
    for (bool goesOn = true; goesOn;) goesOn = takeOne();
  }

  const std::vector<std::string_view>& unwritten() const { return unwritten_; }
  std::size_t end() const { return end_; }

 private:
  /// Goes over a type of at least one name; the name of the first variable is next. A type of the standard library
  /// begins with a value, an array aside, and so does what is static.
  bool isTyped(std::size_t begin) {
    constexpr auto others = std::to_array<std::string_view>(
        {"return", "using",        "typedef",   "goto",  "delete",    "throw",    "else",   "case",
         "struct", "class",        "enum",      "union", "namespace", "template", "friend", "extern",
         "static", "thread_local", "constexpr", "auto",  "operator",  "new"});
    if (std::ranges::find(others, tokens_[begin]) != others.end()) return false;
    if (tokens_[begin] == "std" && tokens_[begin + 3] != "array") return false;
    while (isPartOfType(end_)) end_ = tokens_[end_] == "<" ? behind(end_, "<", ">") : end_ + 1;
    if (end_ < begin + 2 || !tokens_.isName(end_ - 1)) return false;
    --end_;
    return tokens_.isName(begin) && tokens_[end_ - 1] != ":";
  }
  bool isPartOfType(std::size_t i) const {
    return tokens_.isName(i) || tokens_[i] == ":" || tokens_[i] == "<" || tokens_[i] == "*";
  }

  /// Goes over one variable. True when another follows.
  bool takeOne() {
    while (tokens_[end_] == "*") ++end_;
    if (!tokens_.isName(end_)) return false;
    const std::string_view name = tokens_[end_++];
    while (tokens_[end_] == "[") end_ = behind(end_, "[", "]");
    const bool isLast = tokens_[end_] == ";";
    if (isLast || tokens_[end_] == ",") unwritten_.push_back(name);
    while (end_ < tokens_.size() && tokens_[end_] != "," && tokens_[end_] != ";") {
      if (tokens_[end_] == "{" && tokens_[end_ - 1] == ")") return false;  // a function
      end_ = tokens_[end_] == "(" ? behind(end_, "(", ")") : tokens_[end_] == "{" ? behind(end_, "{", "}") : end_ + 1;
    }
    return tokens_[end_++] == ",";
  }

  /// Behind the bracket that closes the one at `i`.
  std::size_t behind(std::size_t i, std::string_view opening, std::string_view closing) const {
    int depth = 0;
    for (; i < tokens_.size(); ++i) {
      if (tokens_[i] == opening) ++depth;
      if (tokens_[i] == closing && --depth == 0) return i + 1;
    }
    return i;
  }

  const TokenList& tokens_;
  std::size_t end_;
  std::vector<std::string_view> unwritten_;
};

/// "L = ...", "f[0] = ...", "f << ...", "f.head<3>() = ...", "f.setZero()": a statement that begins with the name gives
/// it a value, which does not depend on it.
bool isWriting(const TokenList& tokens, std::size_t i) {
  const std::string_view name = tokens[i];
  if (tokens[i + 1] == "." && (tokens[i + 2].starts_with("set") || tokens[i + 2] == "fill")) return true;
  std::size_t sign = i + 1;
  const auto isSign = [&](std::size_t j) {
    const bool isEqual = tokens[j] == "=" && std::string_view("=+-*/<>!").find(tokens[j - 1]) == std::string_view::npos;
    return isEqual || (tokens[j] == "<" && tokens[j + 1] == "<");
  };
  while (sign < tokens.size() && tokens[sign] != ";" && !isSign(sign)) ++sign;
  return isSign(sign) && !tokens.untilSemicolon(sign, [&](std::size_t j) { return tokens[j] == name; });
}

/// Whether the first that happens to a variable, in the block of its declaration, gives it a value.
/// \param begin behind the declaration
bool isWrittenFirst(const TokenList& tokens, std::string_view name, std::size_t begin) {
  int depth = 0;
  for (std::size_t i = begin; i < tokens.size() && depth >= 0; ++i) {
    if (tokens[i] == "{") ++depth;
    if (tokens[i] == "}") --depth;
    if (tokens[i] != name || tokens[i - 1] == ".") continue;
    const bool startsStatement = tokens[i - 1] == ";" || tokens[i - 1] == "{" || tokens[i - 1] == "}";
    const bool startsLoop = tokens[i - 1] == "(" && tokens[i - 2] == "for";
    // Vectors are mostly written entry by entry, in a loop.
    const bool isOfEntry = tokens[i + 1] == "[" || tokens[i + 1] == "(";
    const bool startsBody = tokens[i - 1] == ")" && isOfEntry;
    const bool isSure = depth == 0 || isOfEntry;
    return isSure && (startsStatement || startsLoop || startsBody) && isWriting(tokens, i);
  }
  return true;  // it is not used
}

bool isSuspicious(const StudentFile& file) {
  return mayHideWarnings(file.text) || mayOutliveTemporaries(file.text) || withFilledFlags(file.text) != file.text;
}

}  // namespace

bool mayHideWarnings(std::string_view source) {
  constexpr auto words = std::to_array<std::string_view>(
      {"_Pragma", "__pragma", "__attribute__", "__attribute", "gnu", "asm", "__asm__", "__asm"});
  const TokenList tokens(source);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool isHash = tokens[i] == "#" || (tokens[i] == ":" && i > 0 && tokens[i - 1] == "%");
    if (isHash && isHidingDirective(tokens, i)) return true;
    if (std::ranges::find(words, tokens[i]) != words.end()) return true;
  }
  return false;
}

bool mayOutliveTemporaries(std::string_view source) {
  const TokenList tokens(source);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (isAutoOfTemporaries(tokens, i) || isReferenceFromCall(tokens, i) || isClosureThatLeaves(tokens, i)) return true;
  }
  return false;
}

bool mayReadUnwritten(std::string_view source) {
  const TokenList tokens(source);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const bool startsStatement = i == 0 || tokens[i - 1] == ";" || tokens[i - 1] == "{" || tokens[i - 1] == "}";
    if (!startsStatement) continue;
    const Declaration declaration(tokens, i);
    for (const std::string_view name : declaration.unwritten()) {
      if (!isWrittenFirst(tokens, name, declaration.end())) return true;
    }
  }
  return false;
}

bool wantsOtherFill(const ToolRun& run, const std::vector<StudentFile>& files) {
  const auto isSuspicious = [](const StudentFile& file) {
    return mayHideWarnings(file.text) || mayReadUnwritten(file.text);
  };
  return run.wordsCut || warnsOfUnwritten(run.words, files) || std::ranges::any_of(files, isSuspicious);
}

bool wantsSecondLook(const ToolRun& run, const std::vector<StudentFile>& files) {
  return run.wordsCut || warnsOfMemory(run.words, files) || std::ranges::any_of(files, isSuspicious);
}

std::string sayNoSecondLook(const ToolRun& run, const std::vector<StudentFile>& files) {
  const std::vector<Diagnostic> found = parseDiagnostics(run.words, files);
  const auto error = std::ranges::find_if(found, &Diagnostic::isError);
  const std::string why =
      error == found.end() ? "" : fmt::format(": {}:{}: {}", error->file, error->line, error->message);
  return printableText(
      fmt::format("not looked at a second time, since it does not build with AddressSanitizer{}\n", why));
}

}  // namespace muelle

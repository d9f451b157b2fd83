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

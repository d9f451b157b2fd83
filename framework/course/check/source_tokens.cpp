#include "course/check/source_tokens.h"

#include "base/text/words.h"

#include <algorithm>
#include <string>

namespace muelle {

namespace {

/// Takes a source apart from left to right.
class SourceScanner {
 public:
  explicit SourceScanner(std::string_view text) : text_(text) {}

  std::vector<std::string_view> tokens() {
    while (at_ < text_.size()) step();
    return std::move(tokens_);
  }

 private:
  void step() {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("//")) return skipTo("\n", 0);
    if (rest.starts_with("/*")) return skipTo("*/", 2);
    if (rest.starts_with("R\"")) return skipRawText();
    if (rest.front() == '"' || rest.front() == '\'') return skipQuoted(rest.front());
    if (isNameCharacter(rest.front())) return takeWord();
    if (std::string_view(" \t\r\n\f\v\\").find(rest.front()) == std::string_view::npos) {
      tokens_.push_back(rest.substr(0, 1));
    }
    ++at_;
  }

  void skipTo(std::string_view end, std::size_t past) {
    const std::size_t found = text_.find(end, at_ + past);
    at_ = found == std::string_view::npos ? text_.size() : found + past;
  }

  /// R"name( ... )name"
  void skipRawText() {
    const std::size_t open = std::min(text_.find('(', at_), text_.size());
    const std::string end = ")" + std::string(text_.substr(at_ + 2, open - std::min(open, at_ + 2))) + "\"";
    skipTo(end, end.size());
  }

  /// At most to the end of the line: a lonely ' or " must not swallow the rest.
  void skipQuoted(char quote) {
    for (++at_; at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
  }

  /// A number keeps its digit separators together: 1'000.
  void takeWord() {
    const std::size_t start = at_;
    const bool isNumber = text_[at_] >= '0' && text_[at_] <= '9';
    while (at_ < text_.size() && (isNameCharacter(text_[at_]) || (isNumber && text_[at_] == '\''))) ++at_;
    tokens_.push_back(text_.substr(start, at_ - start));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string_view> tokens_;
};

/// Goes through the tokens of a source, and keeps in mind the outermost braces that are no namespace's.
class FunctionBodies {
 public:
  FunctionBodies(std::string_view source, int line) : source_(source), line_(line) {}

  bool hold(std::string_view token) {
    bool isInside = false;  // of this body
    int start = 0;
    for (const std::string_view word : sourceTokens(source_)) {
      const int line = lineOf(word);
      if (word == token && line == line_) return true;
      if (word == token && depth_ > 0) isInside = true;
      if (word == "{" && enter()) {
        isInside = false;
        start = line;
      }
      if (word == "}" && leave() && isInside && start <= line_ && line_ <= line) return true;
      isNamespace_ = word == "namespace" || word == "extern" || (isNamespace_ && (isName(word) || word == ":"));
    }
    return false;
  }

 private:
  static bool isName(std::string_view word) { return isNameCharacter(word.front()); }

  /// The tokens come in their order.
  int lineOf(std::string_view token) {
    const auto offset = static_cast<std::size_t>(token.data() - source_.data());
    reached_ += static_cast<int>(std::ranges::count(source_.substr(counted_, offset - counted_), '\n'));
    counted_ = offset;
    return reached_;
  }
  /// Whether a body begins.
  bool enter() {
    if (isNamespace_ && depth_ == 0) return false;
    return ++depth_ == 1;
  }
  /// Whether a body ends.
  bool leave() { return depth_ > 0 && --depth_ == 0; }

  std::string_view source_;
  int line_;
  int reached_ = 1;
  std::size_t counted_ = 0;
  int depth_ = 0;
  bool isNamespace_ = false;  ///< "namespace", "namespace a::b", "extern" before a brace
};

}  // namespace

bool isInFunctionOfLine(std::string_view source, int line, std::string_view token) {
  return FunctionBodies(source, line).hold(token);
}

std::string withoutSplices(std::string_view source) {
  std::string text;
  for (std::size_t i = 0; i < source.size(); ++i) {
    std::size_t end = i + 1;  // GCC lets blanks stand behind the backslash
    while (source[i] == '\\' && end < source.size() && std::string_view(" \t\r").find(source[end]) < 3) ++end;
    if (source[i] == '\\' && end < source.size() && source[end] == '\n') {
      i = end;
    } else {
      text += source[i];
    }
  }
  return text;
}

std::vector<std::string_view> sourceTokens(std::string_view source) { return SourceScanner(source).tokens(); }

}  // namespace muelle

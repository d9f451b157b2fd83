#include "course/check/filled_flags.h"

#include "base/text/words.h"
#include "course/check/source_tokens.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace muelle {

namespace {

/// Goes through the tokens with an eye on what each brace opens: only in a function may a statement be inserted.
class Filler {
 public:
  /// \param types of the variables   \param byte what they are filled with
  Filler(std::string_view source, std::vector<std::string_view> types, std::string_view byte)
      : source_(source), types_(std::move(types)), byte_(byte), tokens_(sourceTokens(source)) {}

  std::string filled() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i] == "{") isCode_.push_back(opensCode(i));
      if (tokens_[i] == "}" && !isCode_.empty()) isCode_.pop_back();
      const bool startsStatement = i > 0 && isBreak(tokens_[i - 1]);
      const bool isMeant = std::ranges::find(types_, tokens_[i]) != types_.end();
      if (isMeant && startsStatement && !isCode_.empty() && isCode_.back()) fill(i + 1);
    }
    return result_ + std::string(source_.substr(copied_));
  }

 private:
  static bool isBreak(std::string_view token) { return token == ";" || token == "{" || token == "}"; }

  /// A function, a loop, a block: what has a parenthesis before it or stands in such a one, and is no type.
  bool opensCode(std::size_t brace) const {
    constexpr auto types = std::to_array<std::string_view>({"struct", "class", "union", "enum", "namespace", "="});
    bool hasParenthesis = false;
    for (std::size_t i = brace; i-- > 0 && !isBreak(tokens_[i]);) {
      if (std::ranges::find(types, tokens_[i]) != types.end()) return false;
      hasParenthesis = hasParenthesis || tokens_[i] == ")";
    }
    return hasParenthesis || (!isCode_.empty() && isCode_.back());
  }

  /// `x, y;` becomes `x, y; __builtin_memset(&x, 0xfe, 1); ...`. \param first of the names
  void fill(std::size_t first) {
    std::string statements;
    std::size_t i = first;
    for (;; i += 2) {
      if (i + 1 >= tokens_.size() || !isNameCharacter(tokens_[i].front())) return;
      statements += fmt::format(" __builtin_memset(&{0}, {1}, sizeof {0});", tokens_[i], byte_);
      if (tokens_[i + 1] == ";") break;
      if (tokens_[i + 1] != ",") return;
    }
    const auto end = static_cast<std::size_t>(tokens_[i + 1].data() - source_.data()) + 1;
    result_ += std::string(source_.substr(copied_, end - copied_)) + statements;
    copied_ = end;
  }

  std::string_view source_;
  std::vector<std::string_view> types_;
  std::string_view byte_;
  std::vector<std::string_view> tokens_;
  std::vector<bool> isCode_;  ///< of each open brace
  std::string result_;
  std::size_t copied_ = 0;  ///< how much of the source
};

}  // namespace

std::string withFilledFlags(std::string_view source) { return Filler(source, {"bool"}, "0xfe").filled(); }

std::string withFilledNumbers(std::string_view source) { return Filler(source, {"double", "float"}, "0x7f").filled(); }

}  // namespace muelle

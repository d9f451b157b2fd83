#include "course/check/odd_characters.h"

#include "base/text/utf8.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace muelle {

namespace {

struct LookAlike {
  char32_t code;
  const char* name;
  const char* instead;
};

constexpr auto lookAlikes = std::to_array<LookAlike>({
    {0x00A0, "a no-break space", "type an ordinary space"},
    {0x202F, "a narrow no-break space", "type an ordinary space"},
    {0x2007, "a figure space", "type an ordinary space"},
    {0x3000, "a wide space", "type an ordinary space"},
    {0x200B, "a zero-width space, which no editor shows", "delete it: type the words on both sides again"},
    {0x200C, "a zero-width character, which no editor shows", "delete it: type the words on both sides again"},
    {0x200D, "a zero-width character, which no editor shows", "delete it: type the words on both sides again"},
    {0x2060, "a zero-width character, which no editor shows", "delete it: type the words on both sides again"},
    {0xFEFF, "a byte order mark in the middle of the file", "delete it: type the words on both sides again"},
    {0x2212, "a minus sign of mathematics", "type - of the keyboard"},
    {0x2010, "a hyphen that is no minus", "type - of the keyboard"},
    {0x2011, "a hyphen that is no minus", "type - of the keyboard"},
    {0x2013, "a dash", "type - of the keyboard"},
    {0x2014, "a long dash", "type - of the keyboard"},
    {0x00D7, "a multiplication sign", "type *"},
    {0x22C5, "a multiplication dot", "type *"},
    {0x00B7, "a middle dot", "type * for a product, . for a member"},
    {0x00F7, "a division sign", "type /"},
    {0x2215, "a division slash", "type /"},
    {0x2018, "a curly quote", "type ' of the keyboard"},
    {0x2019, "a curly quote", "type ' of the keyboard"},
    {0x201C, "a curly quote", "type \" of the keyboard"},
    {0x201D, "a curly quote", "type \" of the keyboard"},
    {0x00B4, "an acute accent", "type ' of the keyboard"},
    {0x037E, "a Greek question mark", "type ; of the keyboard"},
    {0xFF1B, "a wide semicolon", "type ; of the keyboard"},
    {0x2264, "a sign of mathematics", "type <="},
    {0x2265, "a sign of mathematics", "type >="},
    {0x2260, "a sign of mathematics", "type !="},
    {0x00B2, "a raised 2", "write x * x or std::pow(x, 2)"},
    {0x00B3, "a raised 3", "write x * x * x or std::pow(x, 3)"},
});

/// Goes over the text outside of comments, texts and characters.
class Scanner {
 public:
  explicit Scanner(const StudentFile& file) : file_(file), rest_(file.text) {}

  std::vector<Diagnostic> run() {
    while (!rest_.empty()) step();
    return std::move(found_);
  }

 private:
  void step() {
    if (rest_.starts_with("//")) return skip(std::min(rest_.find('\n'), rest_.size()));
    if (rest_.starts_with("/*")) return skipPast("*/", 2);
    if (rest_.front() == '"' || rest_.front() == '\'') return skipQuoted(rest_.front());
    if (column_ == 1 && rest_.starts_with("```")) {
      add("three backquotes, with which Markdown begins and ends code", "delete this line");
      return skip(std::min(rest_.find('\n'), rest_.size()));
    }
    if (static_cast<unsigned char>(rest_.front()) < 0x80U) return skip(1);
    const CodePoint point = decodeUtf8(rest_);
    if (!point.valid) {
      add("a byte that is no UTF-8, as an accent saved in Latin-1", "save the file as UTF-8, or delete the character");
      return skip(1);
    }
    const auto known = std::ranges::find(lookAlikes, point.value, &LookAlike::code);
    if (known != lookAlikes.end()) {
      add(fmt::format("{} (U+{:04X})", known->name, static_cast<unsigned>(known->code)), known->instead);
    }
    skip(point.length);
  }

  void add(const std::string& what, const char* instead) {
    const bool isSaid = !found_.empty() && found_.back().line == line_;
    if (!isSaid) found_.push_back({true, file_.name, line_, column_, what + " stands here", instead, ""});
  }

  void skip(std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) {
      column_ = rest_[i] == '\n' ? 1 : column_ + 1;
      line_ += rest_[i] == '\n' ? 1 : 0;
    }
    rest_.remove_prefix(bytes);
  }

  void skipPast(std::string_view end, std::size_t from) {
    const std::size_t at = rest_.find(end, from);
    skip(at == std::string_view::npos ? rest_.size() : at + end.size());
  }

  /// At most to the end of the line: a lonely ' or " must not swallow the rest.
  void skipQuoted(char quote) {
    std::size_t at = 1;
    while (at < rest_.size() && rest_[at] != quote && rest_[at] != '\n') at += rest_[at] == '\\' ? 2 : 1;
    skip(std::min(at + 1, rest_.size()));
  }

  const StudentFile& file_;
  std::string_view rest_;
  int line_ = 1;
  int column_ = 1;
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> oddCharacters(const StudentFile& file) { return Scanner(file).run(); }

}  // namespace muelle

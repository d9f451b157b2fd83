#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace muelle::grader {

/// Of 0 to 9.
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// A piece of C++ source: enough of the language to mutate a solution, not to compile it.
struct Token {
  enum class Kind { Identifier, Number, Literal, Operator };
  Kind kind = Kind::Operator;
  std::string_view text;   ///< into the source
  std::size_t offset = 0;  ///< of its first character
  bool spaceBefore = false;
  bool inTemplateList = false;  ///< stands in a template argument list, brackets included: `<3>` of head<3>()
};

/// The tokens of a source without comments and preprocessor lines, longest operator first ("+=" is one). Text and
/// character literals, raw ones included, are one token each. The views point into `source`.
///
/// A `<` that touches the name before it and has its `>` opens a template argument list; the comparison has blanks
/// around it, as clang-format writes it.
std::vector<Token> tokenise(std::string_view source);

}  // namespace muelle::grader

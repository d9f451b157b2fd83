#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace muelle::grader {

/// One token of a source, replaced.
struct Mutation {
  std::size_t offset = 0;   ///< of the old token
  std::string old;          ///< "+"
  std::string replacement;  ///< "-"; empty: dropped
  int line = 1;
  int column = 1;
  std::string lineText;  ///< the whole line, trimmed: finds the place again when lines have moved
  int occurrence = 1;    ///< which `old` it is in the lines of this text, counted through the file

  /// "+ -> -", or "- -> (dropped)"
  std::string text() const;
  /// "12:5 + -> -"
  std::string place() const;
};

/// Every single-token mutation of a source that is formatted by clang-format:
///
/// - `+` and `-`, `*` and `/` exchanged (`%` becomes either), `+=`, `-=`, `*=`, `/=` inverted or made `=`, `++` and
/// `--`
///   exchanged, `&&` and `||` exchanged, `!` dropped;
/// - every comparison replaced by every other;
/// - a unary minus dropped; one put after `return` and `=`, but where the value is a literal zero or Zero(): -0 is 0;
/// - an integer n becomes n + 1 and n - 1; a floating-point number becomes its double and its half, 0.0 becomes 1.0;
/// - a parameter replaced by every other parameter of its type, in the function's body;
/// - min and max, floor and ceil, sin and cos, norm and squaredNorm, head and tail, Zero and Ones, true and false
/// exchanged;
///   abs and sqrt dropped.
///
/// Declarations' `&` and `*`, template argument lists, using-directives, literals and comments stay as they are.
std::vector<Mutation> mutations(const std::string& source);

/// The source with that one token replaced.
std::string mutated(const std::string& source, const Mutation& mutation);

}  // namespace muelle::grader

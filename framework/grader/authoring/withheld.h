#pragma once
#include "grader/matrix/token.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace muelle::grader {

/// An expression of a source in two forms: as it is, and with its own names replaced by their places, so that the same
/// formula in other names has the same form. "-k * (L - L0)" and "- $0 * ( $1 - $2 )".
struct Expression {
  std::string plain;
  std::string shape;
  std::size_t weight = 0;  ///< tokens, each arithmetic operator three times
  std::size_t offset = 0;  ///< in the source
};

/// What is returned or assigned in a source, a statement each; those with two arithmetic operators at least.
std::vector<Expression> expressionsOf(const std::vector<Token>& source);

/// The bodies of a source's functions, each as one expression: lines that are too short to be told from anybody's may
/// answer an exercise together.
std::vector<Expression> bodiesOf(const std::vector<Token>& source);

/// A number with a fraction and four digits that count, at least: "0.858375"; no round one such as 100.0.
bool isOwnNumber(std::string_view number);

/// What must not be found in a student's tree; each with the file that has it.
struct Withheld {
  std::map<std::string, std::string> plain;   ///< expressions of answers
  std::map<std::string, std::string> shapes;  ///< the longer ones, in whatever names
  std::map<std::string, std::string>
      functions;  ///< that students write -> "exercises/TOPIC/TOPIC.cpp", where they may stand
  std::map<std::string, std::string> bodies;     ///< of functions of answers, in whatever names
  std::map<std::string, std::string> sentences;  ///< of hidden tests
  std::map<std::string, std::string> numbers;    ///< of hidden tests and solutions
  std::map<std::string, std::string> types;      ///< of the instructors' rooms, in two words at least
};

/// Reads solutions/, tests/submissions/*/right, tests/hidden/ and the rooms of framework/ that are not handed out.
Withheld readWithheld(const std::filesystem::path& checkout);

}  // namespace muelle::grader

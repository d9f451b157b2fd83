#include "grader/authoring/lint_contract.h"

#include "base/text/trim.h"
#include "course/contract.h"

#include <fmt/format.h>
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace muelle::grader {

namespace {

/// A contract by lines.
class Contract {
 public:
  Contract(std::string_view text, const std::string& shown) : text_(text), shown_(shown) {
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);) lines_.push_back(line);
  }

  std::vector<Finding> lint() {
    for (const Range& range : rangesOf(text_)) ranges_.insert(range.name);
    for (const std::string& function : functionsOf(text_)) {
      lintFunction(function);
      const std::size_t line = lineOf(function + "(");
      for (const Parameter& parameter : parametersOf(text_, function)) lintParameter(parameter, line);
    }
    return std::move(findings_);
  }

 private:
  void lintFunction(const std::string& function) {
    const std::size_t line = lineOf(function + "(");
    const std::string words = docstringAbove(line);
    if (words.empty()) {
      add(line, fmt::format("{} has no docstring", function), "say above it what it returns, in which unit");
    } else if (!hasUnit(returnsNumbers(line) ? withoutArguments(words) : words)) {
      add(line, fmt::format("the docstring of {} has no unit", function), "write it in brackets: Force [N] on node a");
    }
  }

  /// A struct has units in its own description.
  bool returnsNumbers(std::size_t line) const {
    static const std::regex type(
        R"(^(double|int|Vec\d|VecX|Mat\d|MatX|SparseMatrix|std::vector<(double|int|Vec\d)>) )");
    return std::regex_search(lines_[line], type);
  }

  /// What a docstring says of the function and of what it returns.
  static std::string withoutArguments(const std::string& words) {
    static const std::regex argument(R"(\\param[^\\]*)");
    return std::regex_replace(words, argument, "");
  }

  /// On the line of its function.
  void lintParameter(const Parameter& parameter, std::size_t line) {
    if (!seen_.insert(parameter.name).second) return;
    const bool isNumber = isNumeric(parameter.type);
    const bool isList = parameter.type.find("std::vector") != std::string::npos;
    if ((isNumber || isList) && !ranges_.contains(parameter.name)) {
      add(line, fmt::format("{} has no range", parameter.name),
          fmt::format("add MUELLE_RANGE({}, least, most)", parameter.name));
    }
    const bool isVector = parameter.type.find("Vec") != std::string::npos && !isList;
    if ((isNumber || isVector) && !parameterHasUnit(parameter.name)) {
      add(line, fmt::format("{} has no unit", parameter.name),
          fmt::format("add /// \\param {} ... [unit], or the unit behind its MUELLE_RANGE", parameter.name));
    }
  }

  static bool isNumeric(const std::string& type) {
    return type == "double" || type == "int" || type == "std::size_t" || type == "long";
  }

  /// Its range has a unit, or what is said of it as an argument, or some line that names it. A name in brackets is a
  /// unit: [m].
  bool parameterHasUnit(const std::string& name) const {
    const std::regex range("^MUELLE_RANGE\\(" + name + ",.*\\)\\s*//\\s*\\S");
    const std::regex own("\\\\param\\s+(\\w+\\s*,\\s*)*" + name + "\\b");
    const std::regex word("\\b" + name + "\\b");
    static const std::regex brackets(R"(\[[^\]]*\])");
    bool isTold = false;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (std::regex_search(lines_[i], range)) return true;
      if (!isComment(lines_[i])) continue;
      std::smatch place;
      if (std::regex_search(lines_[i], place, own)) {
        if (hasUnit(paragraphFrom(i, static_cast<std::size_t>(place.position())))) return true;
      } else if (lines_[i].find("\\param") == std::string::npos) {
        const std::string words = std::regex_replace(lines_[i], brackets, "");
        isTold = isTold || (std::regex_search(words, word) && hasUnit(lines_[i]));
      }
    }
    return isTold;
  }

  /// What is said of an argument: from its place in a line to the next command of the comment, or the comment's end.
  std::string paragraphFrom(std::size_t line, std::size_t place) const {
    std::string words = lines_[line].substr(place + 1);
    for (++line; line < lines_.size() && isComment(lines_[line]); ++line) words += lines_[line];
    return words.substr(0, words.find('\\'));
  }

  static bool isComment(const std::string& line) { return line.find("///") != std::string::npos; }

  static bool hasUnit(const std::string& words) {
    static const std::regex unit(
        R"(\[[^\]]+\]|[Uu]nit (vector|normal)|[Dd]irection|[Nn]umbers? of|[Ii]ndex|[Ii]ndices|[Ii]ndexed|[Dd]imensionless|without unit|no unit|[Ww]hether|true)");
    return std::regex_search(words, unit);
  }

  /// The comment that ends right above the line.
  std::string docstringAbove(std::size_t line) const {
    std::string words;
    while (line > 0 && trimmed(lines_[line - 1]).starts_with("///")) words.insert(0, "\n").insert(0, lines_[--line]);
    return words;
  }

  /// Of its declaration: the first line with that text that is no comment; 0 when there is none.
  std::size_t lineOf(const std::string& text) const {
    const auto found = std::ranges::find_if(lines_, [&](const std::string& line) {
      const std::string_view words = trimmed(line);
      return !words.starts_with("//") && !words.starts_with("MUELLE_") && line.find(text) != std::string::npos;
    });
    return found == lines_.end() ? 0 : static_cast<std::size_t>(found - lines_.begin());
  }

  void add(std::size_t line, std::string what, std::string todo) {
    findings_.push_back({fmt::format("{}:{}", shown_, line + 1), std::move(what), std::move(todo)});
  }

  std::string_view text_;
  std::string shown_;
  std::vector<std::string> lines_;
  std::set<std::string> ranges_;
  std::set<std::string> seen_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> lintContract(std::string_view contract, const std::string& shown) {
  try {
    return Contract(contract, shown).lint();
  } catch (const std::exception& error) {
    return {{shown, error.what(), "mend it"}};
  }
}

}  // namespace muelle::grader

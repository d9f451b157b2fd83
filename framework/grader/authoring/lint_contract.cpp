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
      for (const Parameter& parameter : parametersOf(text_, function)) lintParameter(parameter);
    }
    return std::move(findings_);
  }

 private:
  void lintFunction(const std::string& function) {
    const std::size_t line = lineOf(function + "(");
    const std::string words = docstringAbove(line);
    if (words.empty()) {
      add(line, fmt::format("{} has no docstring", function), "say above it what it returns, in which unit");
    } else if (!hasUnit(words)) {
      add(line, fmt::format("the docstring of {} has no unit", function), "write it in brackets: Force [N] on node a");
    }
  }

  void lintParameter(const Parameter& parameter) {
    if (!seen_.insert(parameter.name).second) return;
    const bool isNumber = isNumeric(parameter.type);
    const bool isList = parameter.type.find("std::vector") != std::string::npos;
    const std::size_t line = lineOf(parameter.name);
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

  /// Some line that names the argument has a unit.
  bool parameterHasUnit(const std::string& name) const {
    const std::regex range("^MUELLE_RANGE\\(" + name + ",.*\\)\\s*//\\s*\\S");
    const std::regex word("\\b" + name + "\\b");
    return std::ranges::any_of(lines_, [&](const std::string& line) {
      if (std::regex_search(line, range)) return true;
      return isComment(line) && std::regex_search(line, word) && hasUnit(line);
    });
  }

  static bool isComment(const std::string& line) { return line.find("///") != std::string::npos; }

  static bool hasUnit(const std::string& words) {
    static const std::regex unit(
        R"(\[[^\]]+\]|unit vector|[Dd]irection|[Nn]umbers? of|[Ii]ndex|[Ii]ndices|[Ii]ndexed|[Dd]imensionless|without unit|no unit|[Ww]hether|true)");
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

#include "grader/authoring/leaks.h"

#include "base/text/words.h"
#include "grader/matrix/token.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

bool isSource(const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".h"); }

/// One file against what is withheld.
class Search {
 public:
  Search(const std::string& file, const std::string& text, const Withheld& withheld, std::vector<Leak>& leaks)
      : file_(file), text_(text), withheld_(withheld), leaks_(leaks) {}

  void findAnswers() {
    for (const Expression& expression : expressionsOf(text_)) {
      if (const auto plain = withheld_.plain.find(expression.plain); plain != withheld_.plain.end()) {
        add(expression.offset, fmt::format("answers an exercise: {}stands in {}", expression.plain, plain->second));
      } else if (const auto shape = withheld_.shapes.find(expression.shape); shape != withheld_.shapes.end()) {
        add(expression.offset,
            fmt::format("answers an exercise in other names: {}is of {}", expression.plain, shape->second));
      }
    }
  }

  void findBodies() {
    for (const Expression& body : bodiesOf(text_)) {
      if (const auto found = withheld_.bodies.find(body.shape); found != withheld_.bodies.end()) {
        add(body.offset, fmt::format("answers an exercise: the function is one of {}", found->second));
      }
    }
  }

  /// NAME ( ... ) {, but in the stub, and in its contract, which may turn a call into one of the student's classes.
  void findDefinitions() {
    const std::vector<Token> tokens = tokenise(text_);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const auto function = withheld_.functions.find(std::string(tokens[i].text));
      if (function == withheld_.functions.end() || isOfTheExercise(function->second)) continue;
      if (isDefinition(tokens, i)) {
        add(tokens[i].offset, fmt::format("defines {}, which students write", function->first));
      }
    }
  }

  void findNumbers() {
    for (const Token& token : tokenise(text_)) {
      const auto number = withheld_.numbers.find(std::string(token.text));
      if (token.kind == Token::Kind::Number && number != withheld_.numbers.end()) {
        add(token.offset, fmt::format("has the number {} of {}", token.text, number->second));
      }
    }
  }

  void findSentences() {
    for (const auto& [sentence, where] : withheld_.sentences) {
      const std::size_t place = text_.find(sentence);
      if (place != std::string::npos) add(place, fmt::format("has a sentence of {}: {}", where, sentence));
    }
  }

  /// Words of code, comments and pages. \param known names of what is handed out
  void findNames(const std::set<std::string>& known) {
    for (std::size_t i = 0; i < text_.size();) {
      std::size_t end = i;
      while (end < text_.size() && isNameCharacter(text_[end]) && (end > i || !isDigit(text_[end]))) ++end;
      const std::string word = text_.substr(i, end - i);
      const auto type = withheld_.types.find(word);
      if (type != withheld_.types.end() && !known.contains(word)) {
        add(i, fmt::format("names {} of {}", word, type->second));
      }
      i = std::max(end, i + 1);
    }
  }

  /// The first one says enough.
  void findMark() {
    const std::size_t place = text_.find(writeMark);
    if (place != std::string::npos) add(place, "is still to be written (./muelle lint names each line)");
  }

  void findPaths(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      const std::size_t place = path.size() > 1 ? text_.find(path) : std::string::npos;
      if (place != std::string::npos) add(place, fmt::format("has a path of this machine: {}", path));
    }
  }

 private:
  static bool isDefinition(const std::vector<Token>& tokens, std::size_t i) {
    if (i + 1 >= tokens.size() || tokens[i + 1].text != "(") return false;
    int depth = 0;
    for (std::size_t j = i + 1; j < tokens.size(); ++j) {
      if (tokens[j].text == "(") ++depth;
      if (tokens[j].text == ")" && --depth == 0) return j + 1 < tokens.size() && tokens[j + 1].text == "{";
    }
    return false;
  }

  /// \param stub "exercises/TOPIC/TOPIC.cpp"
  bool isOfTheExercise(const std::string& stub) const {
    return file_ == stub || file_ == stub.substr(0, stub.size() - 3) + "h";
  }

  void add(std::size_t offset, std::string what) {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(offset);
    leaks_.push_back({file_, 1 + static_cast<int>(std::count(text_.begin(), end, '\n')), std::move(what)});
  }

  const std::string& file_;
  const std::string& text_;
  const Withheld& withheld_;
  std::vector<Leak>& leaks_;
};

/// Rooms and folders that are not for students.
bool isWithheldFile(const std::string& file) {
  static constexpr const char* folders[] = {"framework/engine/",
                                            "framework/lab/",
                                            "framework/grader/",
                                            "solutions/",
                                            "framework/app/instructor/",
                                            "tests/",
                                            "plots/",
                                            "docs/",
                                            ".git/"};
  return std::ranges::any_of(folders, [&file](const char* folder) { return file.starts_with(folder); });
}

std::set<std::string> namesIn(const Tree& tree) {
  std::set<std::string> names;
  for (const auto& [file, text] : tree) {
    if (!isSource(file)) continue;
    for (const Token& token : tokenise(text)) {
      if (token.kind == Token::Kind::Identifier) names.emplace(token.text);
    }
  }
  return names;
}

}  // namespace

std::string Leak::text() const { return fmt::format("{}:{} {}", file, line, what); }

std::vector<Leak> findLeaks(const Tree& tree, const Withheld& withheld, const std::vector<std::string>& paths) {
  std::vector<Leak> leaks;
  const std::set<std::string> known = namesIn(tree);
  for (const auto& [file, text] : tree) {
    if (isWithheldFile(file)) leaks.push_back({file, 1, "is no student's"});
    Search search(file, text, withheld, leaks);
    if (isSource(file)) {
      search.findAnswers();
      search.findBodies();
      search.findDefinitions();
      // The ends of a contract's ranges are passed by its hidden tests.
      if (!file.starts_with("exercises/") || !file.ends_with(".h")) search.findNumbers();
    }
    // What an author says in public, too, is not the hidden tests' own.
    if (!file.starts_with("exercises/")) search.findSentences();
    if (file.starts_with("exercises/")) search.findMark();
    search.findNames(known);
    search.findPaths(paths);
  }
  return leaks;
}

}  // namespace muelle::grader

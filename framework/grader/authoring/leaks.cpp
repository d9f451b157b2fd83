#include "grader/authoring/leaks.h"

#include "base/text/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace muelle::grader {

namespace {

using Tokens = std::vector<Token>;

bool isSource(const std::string& file) { return file.ends_with(".cpp") || file.ends_with(".h"); }

/// One file against what is withheld.
class Search {
 public:
  /// \param tokens of a source; none of another file
  Search(const std::string& file, const std::string& text, const Tokens& tokens, const Withheld& withheld,
         std::vector<Leak>& leaks)
      : file_(file), text_(text), tokens_(tokens), withheld_(withheld), leaks_(leaks) {}

  void findAnswers() {
    for (const Expression& expression : expressionsOf(tokens_)) {
      if (const auto plain = withheld_.plain.find(expression.plain); plain != withheld_.plain.end()) {
        add(expression.offset, fmt::format("answers an exercise: {}stands in {}", expression.plain, plain->second));
      } else if (const auto shape = withheld_.shapes.find(expression.shape); shape != withheld_.shapes.end()) {
        add(expression.offset,
            fmt::format("answers an exercise in other names: {}is of {}", expression.plain, shape->second));
      }
    }
  }

  void findBodies() {
    for (const Expression& body : bodiesOf(tokens_)) {
      if (const auto found = withheld_.bodies.find(body.shape); found != withheld_.bodies.end()) {
        add(body.offset, fmt::format("answers an exercise: the function is one of {}", found->second));
      }
    }
  }

  /// NAME ( ... ) {, but in the stub, and in its contract, which may turn a call into one of the student's classes.
  void findDefinitions() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto function = withheld_.functions.find(std::string(tokens_[i].text));
      if (function == withheld_.functions.end() || isOfTheExercise(function->second)) continue;
      if (isDefinition(i)) {
        add(tokens_[i].offset, fmt::format("defines {}, which students write", function->first));
      }
    }
  }

  void findNumbers() {
    for (const Token& token : tokens_) {
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
  bool isDefinition(std::size_t i) const {
    if (i + 1 >= tokens_.size() || tokens_[i + 1].text != "(") return false;
    int depth = 0;
    for (std::size_t j = i + 1; j < tokens_.size(); ++j) {
      if (tokens_[j].text == "(") ++depth;
      if (tokens_[j].text == ")" && --depth == 0) return j + 1 < tokens_.size() && tokens_[j + 1].text == "{";
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
  const Tokens& tokens_;
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

/// path -> tokens, which point into the tree; none of what is no source
std::map<std::string, Tokens> tokensIn(const Tree& tree) {
  std::map<std::string, Tokens> tokens;
  for (const auto& [file, text] : tree) tokens[file] = isSource(file) ? tokenise(text) : Tokens{};
  return tokens;
}

std::set<std::string> namesIn(const std::map<std::string, Tokens>& sources) {
  std::set<std::string> names;
  for (const auto& [file, tokens] : sources) {
    for (const Token& token : tokens) {
      if (token.kind == Token::Kind::Identifier) names.emplace(token.text);
    }
  }
  return names;
}

}  // namespace

std::string Leak::text() const { return fmt::format("{}:{} {}", file, line, what); }

std::vector<Leak> findLeaks(const Tree& tree, const Withheld& withheld, const std::vector<std::string>& paths) {
  std::vector<Leak> leaks;
  const std::map<std::string, Tokens> tokens = tokensIn(tree);
  const std::set<std::string> known = namesIn(tokens);
  for (const auto& [file, text] : tree) {
    if (isWithheldFile(file)) leaks.push_back({file, 1, "is no student's"});
    Search search(file, text, tokens.at(file), withheld, leaks);
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

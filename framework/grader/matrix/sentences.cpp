#include "grader/matrix/sentences.h"

#include "base/file.h"
#include "grader/matrix/token.h"

#include <fmt/format.h>
#include <cctype>
#include <sstream>
#include <string_view>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The end of the number that begins at `at`: digits, a point, an exponent; hexadecimal, too.
std::size_t endOfNumber(std::string_view text, std::size_t at) {
  const bool isHexadecimal = text.substr(at).starts_with("0x");
  while (at < text.size()) {
    const char c = text[at];
    const bool isSign = (c == '-' || c == '+') && (text[at - 1] == 'e' || text[at - 1] == 'p');
    const bool isPart = isDigit(c) || c == '.' || c == 'e' || isSign || (isHexadecimal && (isLetter(c) || isDigit(c)));
    if (!isPart) break;
    ++at;
  }
  // A point that ends the sentence, an e that begins a word.
  while (text[at - 1] == '.' || text[at - 1] == 'e') --at;
  return at;
}

/// "-1.5e-3" becomes "#"; L0 and Vec3 stay.
std::string withoutNumbers(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const char before = plain.empty() ? ' ' : plain.back();
    if (isDigit(text[at]) && !isLetter(before) && !isDigit(before)) {
      const bool isNegative =
          before == '-' &&
          (plain.size() < 2 || std::string_view(" (,").find(plain[plain.size() - 2]) != std::string_view::npos);
      if (isNegative) plain.pop_back();
      plain += '#';
      at = endOfNumber(text, at);
    } else {
      plain += text[at++];
    }
  }
  return plain;
}

/// Lists of any length are one.
std::string withShortLists(std::string text) {
  for (std::size_t at = text.find("#, #"); at != std::string::npos; at = text.find("#, #")) text.erase(at, 3);
  return text;
}

}  // namespace

std::set<std::string> sentencesOf(const GradedExercise& exercise) {
  std::set<std::string> sentences;
  if (exercise.build.status != BuildOutcome::Status::Built) return sentences;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    for (const std::string& line : feedback(criterion, exercise)) {
      sentences.insert(withShortLists(withoutNumbers(line)));
    }
  }
  return sentences;
}

std::set<std::string> readSentences(const fs::path& file) {
  std::set<std::string> sentences;
  if (!fs::exists(file)) return sentences;
  std::istringstream text(readFile(file));
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("# ")) sentences.insert(line);
  }
  return sentences;
}

void writeSentences(const fs::path& file, const std::set<std::string>& sentences) {
  std::string text =
      "# Every sentence that the submissions beside this file are told, # for a number. Written by:\n"
      "# ./muelle test-the-tests TOPIC --remember\n";
  for (const std::string& sentence : sentences) text += sentence + '\n';
  writeFile(file, text);
}

std::vector<std::string> differencesOfSentences(const fs::path& file, const std::set<std::string>& sentences,
                                                bool isComplete) {
  std::vector<std::string> lines;
  if (!fs::exists(file)) return lines;
  const std::set<std::string> golden = readSentences(file);
  for (const std::string& sentence : sentences) {
    if (!golden.contains(sentence))
      lines.push_back(fmt::format("{} does not know: {}", file.filename().string(), sentence));
  }
  for (const std::string& sentence : golden) {
    if (isComplete && !sentences.contains(sentence)) {
      lines.push_back(fmt::format("{} has what nobody is told: {}", file.filename().string(), sentence));
    }
  }
  return lines;
}

}  // namespace muelle::grader

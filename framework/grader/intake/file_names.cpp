#include "grader/intake/file_names.h"

#include "base/text/lists.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace muelle::grader {

namespace {

constexpr std::array<std::string_view, 6> sourceSuffixes{".cpp", ".cc", ".cxx", ".c++", ".cp", ".c"};
constexpr std::array<std::string_view, 5> headerSuffixes{".h", ".hpp", ".hh", ".hxx", ".h++"};
// The longer before the shorter that it ends with.
constexpr std::array<std::string_view, 13> archiveSuffixes{".tar.gz", ".tar.bz2", ".tar.xz", ".tar.zst", ".tgz",
                                                           ".tbz2",   ".tbz",     ".txz",    ".tzst",    ".tar",
                                                           ".zip",    ".7z",      ".zipx"};
constexpr std::array<std::string_view, 5> copyWords{"copy", "copia", "kopie", "copie", "download"};
constexpr std::string_view moodleMark = "_assignsubmission_file_";
constexpr std::size_t digitsOfACopy = 2;
constexpr std::string_view separators = "-_ .()[]";

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// "cpp" for every suffix of a source, "h" for every one of a header: which of them it is makes no difference.
struct SplitName {
  std::string stem;
  std::string kind;
};

template <class Suffixes>
bool cutSuffix(std::string& name, const Suffixes& suffixes) {
  for (const std::string_view suffix : suffixes) {
    if (name.size() > suffix.size() && name.ends_with(suffix)) {
      name.resize(name.size() - suffix.size());
      return true;
    }
  }
  return false;
}

SplitName split(std::string name) {
  if (cutSuffix(name, sourceSuffixes)) return {name, "cpp"};
  if (cutSuffix(name, headerSuffixes)) return {name, "h"};
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot == 0) return {name, ""};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

/// The words between hyphens, underscores, blanks, dots and brackets.
std::vector<std::string> wordsOf(std::string_view stem) {
  std::vector<std::string> words(1);
  for (const char c : stem) {
    if (separators.find(c) == std::string_view::npos) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool isCopyWord(const std::string& word) {
  return std::find(copyWords.begin(), copyWords.end(), word) != copyWords.end();
}

bool isCopyNumber(const std::string& word) {
  return !word.empty() && word.size() <= digitsOfACopy && std::all_of(word.begin(), word.end(), isDigit);
}

/// Takes away what browsers, editors and mail put behind a suffix: "(1)", ".1", ".download", ".txt", " copy".
bool cutTail(std::string& name) {
  const std::size_t end = name.find_last_not_of(" )]");
  if (end == std::string::npos) return false;
  const std::size_t mark = name.find_last_of(separators, end);
  if (mark == std::string::npos || mark == 0) return false;
  const std::string word = name.substr(mark + 1, end - mark);
  if (word != "txt" && !isCopyWord(word) && !isCopyNumber(word)) return false;
  name.resize(mark);
  name.erase(name.find_last_not_of(separators) + 1);
  return !name.empty();
}

/// Lower case, without blanks around, Moodle's mark and what stands behind the suffix of a source or header.
SplitName splitAsWanted(std::string_view raw) {
  std::string name = lowerCase(trimmed(raw));
  if (const std::size_t mark = name.find(moodleMark); mark != std::string::npos)
    name.erase(0, mark + moodleMark.size());
  std::string bare = name;
  do {
    SplitName parts = split(bare);
    if (parts.kind == "cpp" || parts.kind == "h") return parts;
  } while (cutTail(bare));
  return split(name);
}

std::vector<std::string> withoutCopyOf(std::vector<std::string> words) {
  const bool hasFront = words.size() > 2 && isCopyWord(words[0]) && (words[1] == "of" || words[1] == "de");
  if (hasFront) words.erase(words.begin(), words.begin() + 2);
  return words;
}

bool endsAsACopy(const std::vector<std::string>& words) {
  return words.size() > 1 && (isCopyWord(words.back()) || isCopyNumber(words.back()));
}

/// The marks are taken away one after the other, since a wanted name may end with a number of its own.
bool areNear(const std::string& stem, const std::string& wanted) {
  const std::vector<std::string> asked = wordsOf(wanted);
  std::vector<std::string> words = wordsOf(stem);
  if (words == asked) return true;
  words = withoutCopyOf(std::move(words));
  while (words != asked && endsAsACopy(words)) words.pop_back();
  return words == asked;
}

}  // namespace

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool isSourceName(std::string_view name) { return splitAsWanted(name).kind == "cpp"; }

bool isNearName(const std::string& name, const std::string& wanted) {
  if (name == wanted) return false;
  const SplitName given = splitAsWanted(name);
  const SplitName asked = splitAsWanted(wanted);
  return given.kind == asked.kind && areNear(given.stem, asked.stem);
}

bool isTextNamedAs(const std::string& name, const std::string& wanted) {
  const SplitName given = splitAsWanted(name);
  const SplitName asked = splitAsWanted(wanted);
  return given.kind == "txt" && asked.kind == "cpp" && areNear(given.stem, asked.stem);
}

bool isNamedAlike(const std::string& name, const std::string& wanted) {
  const std::string stem = plainStem(name);
  const std::string asked = plainStem(wanted);
  return stem == asked || stem == asked + "_cpp";
}

bool isNearFolderName(const std::string& name, const std::string& topic) {
  return name != topic && areNear(lowerCase(name), lowerCase(topic));
}

std::string plainStem(const std::string& name) {
  std::vector<std::string> words = withoutCopyOf(wordsOf(splitAsWanted(name).stem));
  while (endsAsACopy(words)) words.pop_back();
  return joined(words, "_");
}

bool isArchiveName(std::string_view name) {
  std::string lower = lowerCase(name);
  return cutSuffix(lower, archiveSuffixes);
}

std::string withoutSourceSuffix(const std::string& name) {
  const std::string stem = splitAsWanted(name).stem;
  return name.substr(0, lowerCase(name).find(stem) + stem.size());
}

std::string withoutArchiveSuffix(const std::string& name) {
  std::string lower = lowerCase(name);
  cutSuffix(lower, archiveSuffixes);
  return name.substr(0, lower.size());
}

}  // namespace muelle::grader

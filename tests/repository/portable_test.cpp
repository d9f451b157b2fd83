/// \file
/// What is handed out works on a student's machine, macOS with its bash 3.2 included: refused_words.h lists what would
/// not.

#include "folders.h"
#include "refused_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace muelle {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(std::istream& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A line's first words, of which `#  if` is one: "#if defined(__linux__)".
std::string directive(const std::string& line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line[hash] != '#') return "";
  const std::size_t word = line.find_first_not_of(" \t", hash + 1);
  return word == std::string::npos ? "" : "#" + line.substr(word);
}

/// Follows #if, #else and #endif: which lines are for Linux alone.
class LinuxParts {
 public:
  /// Whether the line, the next one, stands in a part for Linux alone.
  bool take(const std::string& line) {
    const std::string text = directive(line);
    if (text.starts_with("#if")) {
      parts_.push_back({isForLinux(text), isNotForLinux(text)});
    } else if (text.starts_with("#el") && !parts_.empty()) {
      Part& part = parts_.back();
      part.isLinux = text.starts_with("#else") ? part.isOthers : isForLinux(text);
      part.isOthers = false;
    } else if (text.starts_with("#endif") && !parts_.empty()) {
      parts_.pop_back();
    }
    return std::ranges::any_of(parts_, &Part::isLinux);
  }

 private:
  struct Part {
    bool isLinux;
    bool isOthers;  ///< the part for all but Linux: what follows #else is Linux's
  };

  /// Linux's are, too, its C library's own and the numbers of system calls, where the file asks for them.
  static bool isForLinux(const std::string& text) {
    static const std::regex words(R"(^#(el)?if(def)?\s+(defined\s*\(?\s*)?(__linux__|__GLIBC__|SYS_\w+)\)?\s*$)");
    return std::regex_search(text, words);
  }
  static bool isNotForLinux(const std::string& text) {
    static const std::regex words(R"(^#if(ndef\s+|\s+!\s*defined\s*\(?\s*)__linux__\)?\s*$)");
    return std::regex_search(text, words);
  }

  std::vector<Part> parts_;
};

/// The line without its comment, where that is one to its end.
std::string withoutComment(const std::string& line, const std::string& mark) {
  bool inText = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) inText = !inText;
    const bool begins = i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t' || mark == "//";
    if (!inText && begins && line.compare(i, mark.size(), mark) == 0) return line.substr(0, i);
  }
  return line;
}

/// A list of refused words, ready to be looked for.
class Refusal {
 public:
  template <class Words>
  explicit Refusal(const Words& words) {
    for (const RefusedWord& word : words) expressions_.emplace_back(std::regex(word.word), word.reason);
  }

  /// Adds "7: pipe2(: why" for each of them that stands in the line.
  void findIn(const std::string& line, std::size_t number, std::vector<std::string>& found) const {
    for (const auto& [expression, reason] : expressions_) {
      std::smatch match;
      if (!std::regex_search(line, match, expression)) continue;
      found.push_back(std::to_string(number) + ": " + match.str() + ": " + reason);
    }
  }

 private:
  std::vector<std::pair<std::regex, std::string>> expressions_;
};

std::vector<std::string> refusedInSource(std::istream& stream) {
  static const Refusal refusal(refusedInSources);
  std::vector<std::string> found;
  LinuxParts parts;
  std::size_t number = 0;
  for (const std::string& line : linesOf(stream)) {
    ++number;
    if (!parts.take(line)) refusal.findIn(withoutComment(line, "//"), number, found);
  }
  return found;
}

std::vector<std::string> refusedInScript(std::istream& stream) {
  static const Refusal refusal(refusedInLauncher);
  std::vector<std::string> found;
  std::size_t number = 0;
  for (const std::string& line : linesOf(stream)) refusal.findIn(withoutComment(line, "#"), ++number, found);
  return found;
}

/// The sources of what is handed out.
std::vector<fs::path> handedOut() {
  std::vector<fs::path> files;
  const auto take = [&files](const fs::directory_entry& entry) {
    const fs::path& file = entry.path();
    if (entry.is_regular_file() && (file.extension() == ".h" || file.extension() == ".cpp")) files.push_back(file);
  };
  std::vector<fs::path> folders = {"exercises"};
  std::istringstream rooms(MUELLE_HANDED_OUT_ROOMS);
  for (std::string room; rooms >> room;) folders.push_back(fs::path("framework") / room);
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) take(entry);
  }
  for (const auto& entry : fs::directory_iterator(source / "framework/app")) take(entry);  // not app/instructor
  return files;
}

void expectNone(const std::vector<std::string>& found, const fs::path& file) {
  for (const std::string& one : found) ADD_FAILURE() << fs::relative(file, source).string() << ":" << one;
}

TEST(Portable, WhatIsHandedOutCallsNothingThatMacOsLacks) {
  for (const fs::path& file : handedOut()) {
    std::ifstream stream(file);
    expectNone(refusedInSource(stream), file);
  }
}

TEST(Portable, TheLauncherNeedsBash32AndTheCommandsOfMacOsAlone) {
  std::ifstream stream(source / "muelle");
  expectNone(refusedInScript(stream), source / "muelle");
}

std::size_t countInSource(const std::string& text) {
  std::istringstream stream(text);
  return refusedInSource(stream).size();
}

std::size_t countInScript(const std::string& text) {
  std::istringstream stream(text);
  return refusedInScript(stream).size();
}

TEST(Portable, CallsAreSeenOutsideOfWhatIsForLinuxAlone) {
  EXPECT_EQ(countInSource("pipe2(ends, O_CLOEXEC);"), 1U);
  EXPECT_EQ(countInSource("readFile(\"/proc/self/maps\");  // why"), 1U);
  EXPECT_EQ(countInSource("#include <sys/prctl.h>"), 1U);
  EXPECT_EQ(countInSource("// pipe2( is Linux's"), 0U);
  EXPECT_EQ(countInSource("{\"pipe2\", \"\", files},"), 0U) << "a name in a list is no call";
  EXPECT_EQ(countInSource("#ifdef __linux__\nprctl(1);\n#else\nprctl(2);\n#endif\nprctl(3);"), 2U);
  EXPECT_EQ(countInSource("#ifndef __linux__\nprctl(1);\n#else\nprctl(2);\n#endif"), 1U);
  EXPECT_EQ(countInSource("#if defined(__linux__)\n#ifdef X\nprctl(1);\n#endif\nprctl(2);\n#endif"), 0U);
  EXPECT_EQ(countInSource("#if defined(__linux__) || defined(__APPLE__)\nprctl(1);\n#endif"), 1U);
  EXPECT_GT(handedOut().size(), 80U);
}

TEST(Portable, LaterWordsOfTheShellAreSeen) {
  for (const char* line :
       {"mapfile -t lines < <(ls)", "declare -A map", "echo ${x^^}", "echo ${x,}", "flock 9", "readlink -f muelle",
        "stat -c %U .", "sed -i s/a/b/ file", "timeout 5 ls", "\"${as_root[@]}\" apt-get", "cmd &>>log", "cmd |& cat",
        "local -n name=$1", "printf '\\e[K'", "setsid ls", "cp -a x y", "ls --color", "wait -n"}) {
    EXPECT_EQ(countInScript(line), 1U) << line;
  }
  for (const char* line : {"# flock is not there", "${as_root[@]+\"${as_root[@]}\"} apt-get", "apt-get install --yes x",
                           "readlink \"$x\"", "local x=()", "read -ra words", "echo ${x%%,*}", "printf '%s' \"$x\""}) {
    EXPECT_EQ(countInScript(line), 0U) << line;
  }
}

}  // namespace
}  // namespace muelle

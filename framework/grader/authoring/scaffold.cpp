#include "grader/authoring/scaffold.h"

#include "base/file.h"
#include "base/text/printable.h"
#include "course/manifest.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr const char* templateFolder = "framework/grader/authoring/scaffold";
constexpr std::size_t longestName = 40;
constexpr int orderStep = 10;  // between neighbours, so that one may come between

/// A file of the scaffold and where it goes; @topic@ stands for the name in both.
struct Template {
  const char* name;
  const char* path;
};

constexpr Template templatesOfFiles[] = {
    {"README.md", "exercises/@topic@/README.md"},
    {"figure.svg", "exercises/@topic@/figure.svg"},
    {"topic.h", "exercises/@topic@/@topic@.h"},
    {"topic.cpp", "exercises/@topic@/@topic@.cpp"},
    {"public_test.cpp", "exercises/@topic@/public_test.cpp"},
    {"demo.cpp", "exercises/@topic@/demo.cpp"},
    {"exercise.toml", "exercises/@topic@/exercise.toml"},
    {"solution.cpp", "solutions/@topic@/@topic@.cpp"},
    {"hidden_test.cpp", "tests/hidden/@topic@/@topic@_test.cpp"},
    {"oracle.cpp", "tests/hidden/@topic@/oracle.cpp"},
    {"mistakes.cpp", "tests/hidden/@topic@/mistakes.cpp"},
    {"right.cpp", "tests/submissions/@topic@/right/in_two_steps/@topic@.cpp"},
    {"wrong.cpp", "tests/submissions/@topic@/wrong/wrong_sign/@topic@.cpp"},
    {"zero.cpp", "tests/submissions/@topic@/wrong/zero/@topic@.cpp"},
    {"constant.cpp", "tests/submissions/@topic@/wrong/constant/@topic@.cpp"},
    {"stateful.cpp", "tests/submissions/@topic@/wrong/stateful/@topic@.cpp"},
    {"mutants.toml", "tests/submissions/@topic@/mutants.toml"},
};

bool isLower(char c) { return c >= 'a' && c <= 'z'; }
bool isLowerOrDigit(char c) { return isLower(c) || (c >= '0' && c <= '9'); }

/// Words of lower-case letters and digits with one _ between, the first of which begins with a letter.
bool isTopicName(const std::string& topic) {
  if (topic.empty() || topic.size() > longestName || !isLower(topic.front()) || topic.back() == '_') return false;
  for (std::size_t i = 0; i < topic.size(); ++i) {
    if (topic[i] == '_' ? topic[i - 1] == '_' : !isLowerOrDigit(topic[i])) return false;
  }
  return true;
}

void refuseBadName(const fs::path& checkout, const std::string& topic) {
  if (!isTopicName(topic)) {
    throw std::invalid_argument(fmt::format(
        "'{}' is no name of an exercise: take words of a-z and digits with _ between, {} letters at most, as spring_3d",
        printableLine(topic), longestName));
  }
  for (const fs::path& folder : foldersOf(topic)) {
    if (fs::exists(checkout / folder)) {
      throw std::invalid_argument(fmt::format("{} exists already: take another name", folder.generic_string()));
    }
  }
}

char upper(char c) { return isLower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

/// "hanging_chain" -> "hangingChainForce"
std::string functionName(const std::string& topic) {
  std::string name;
  for (std::size_t i = 0; i < topic.size(); ++i) {
    if (topic[i] != '_') name += i > 0 && topic[i - 1] == '_' ? upper(topic[i]) : topic[i];
  }
  return name + "Force";
}

/// "hanging_chain" -> "Hanging chain"
std::string titleOf(std::string topic) {
  std::ranges::replace(topic, '_', ' ');
  topic.front() = upper(topic.front());
  return topic;
}

/// The next tens behind the last exercise.
int nextOrder(const fs::path& checkout) {
  const std::vector<Manifest> course = readCourse(checkout / "exercises");
  return course.empty() ? orderStep : (course.back().order / orderStep + 1) * orderStep;
}

std::string replaced(std::string text, const std::string& name, const std::string& value) {
  const std::string place = "@" + name + "@";
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + value.size())) {
    text.replace(at, place.size(), value);
  }
  return text;
}

}  // namespace

std::vector<fs::path> foldersOf(const std::string& topic) {
  std::vector<fs::path> folders;
  for (const char* room : {"exercises", "solutions", "tests/hidden", "tests/submissions"}) {
    folders.push_back(fs::path(room) / topic);
  }
  return folders;
}

Tree scaffoldOf(const fs::path& checkout, const std::string& topic) {
  refuseBadName(checkout, topic);
  const std::string order = std::to_string(nextOrder(checkout));
  Tree tree;
  for (const Template& file : templatesOfFiles) {
    std::string text = readFile(checkout / templateFolder / (std::string(file.name) + ".in"));
    text = replaced(std::move(text), "order", order);
    text = replaced(std::move(text), "title", titleOf(topic));
    text = replaced(std::move(text), "function", functionName(topic));
    tree[replaced(file.path, "topic", topic)] = replaced(std::move(text), "topic", topic);
  }
  return tree;
}

void writeScaffold(const fs::path& checkout, const std::string& topic, const Tree& tree) {
  const TemporaryFolder scratch(checkout / "build");
  for (const auto& [file, text] : tree) {
    fs::create_directories((scratch.path() / file).parent_path());
    writeFile(scratch.path() / file, text);
  }
  std::vector<fs::path> made;
  try {
    for (const fs::path& folder : foldersOf(topic)) {
      fs::create_directories((checkout / folder).parent_path());
      fs::rename(scratch.path() / folder, checkout / folder);
      made.push_back(checkout / folder);
    }
  } catch (...) {
    for (const fs::path& folder : made) fs::remove_all(folder);
    throw;
  }
}

}  // namespace muelle::grader

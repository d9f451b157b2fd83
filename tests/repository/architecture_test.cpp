/// \file
/// The arrows of the house: what a room may include is stated once, here; every quoted #include of every source is held
/// against it.

#include "folders.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

using Rooms = std::set<std::string>;

struct Include {
  fs::path file;
  int line;
  std::string target;
};

bool isSource(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

/// What a line includes, "" when it includes nothing.
std::string includedBy(const std::string& line) {
  std::string word;
  std::string target;
  std::istringstream words(line);
  words >> word;
  if (word == "#") {
    words >> target;
    word += target;
  }
  if (!word.starts_with("#include")) return "";
  std::getline(words, target);
  target = word.substr(8) + target;  // #include"x" has no blank
  const std::size_t open = target.find_first_of("<\"");
  if (open == std::string::npos) return "";
  return target.substr(open + 1, target.find_first_of(">\"", open + 1) - open - 1);
}

std::vector<Include> includesBelow(const fs::path& folder) {
  std::vector<Include> includes;
  if (!fs::exists(folder)) return includes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || !isSource(entry.path())) continue;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      const std::string target = includedBy(line);
      if (!target.empty()) includes.push_back({entry.path(), number, target});
    }
  }
  return includes;
}

/// The room that an include names, "" when it is none of ours.
std::string roomOf(const std::string& target) {
  static const Rooms rooms = {"base",   "harness", "figures",   "course", "engine",   "lab",
                              "grader", "app",     "solutions", "tests",  "exercises"};
  const std::string first = target.substr(0, target.find('/'));
  return target.find('/') != std::string::npos && rooms.contains(first) ? first : "";
}

void expectOnly(const fs::path& folder, const Rooms& allowed) {
  for (const Include& include : includesBelow(source / folder)) {
    const std::string room = roomOf(include.target);
    const bool climbs = include.target.find("..") != std::string::npos;
    EXPECT_TRUE((room.empty() || allowed.contains(room)) && !climbs)
        << fs::relative(include.file, source).string() << ":" << include.line << " includes " << include.target
        << ", which " << folder.string() << " must not stand on";
  }
}

/// What each room stands on, itself included.
const std::map<std::string, Rooms> house = {
    {"framework/base", {"base"}},
    {"framework/harness", {"base", "harness"}},
    {"framework/figures", {"base", "harness", "figures"}},
    {"framework/course", {"base", "harness", "figures", "course"}},
    {"framework/engine", {"base", "harness", "engine"}},
    {"framework/lab", {"base", "harness", "figures", "engine", "lab"}},
    {"framework/grader", {"base", "harness", "figures", "course", "grader"}},
    {"framework/app", {"base", "harness", "figures", "course", "engine", "lab", "grader", "app"}},
    {"exercises", {"harness", "course"}},
    {"tests/hidden", {"harness", "course", "engine", "grader"}},
};

TEST(Architecture, EachRoomStandsOnTheRoomsAboveIt) {
  for (const auto& [folder, rooms] : house) expectOnly(folder, rooms);
}

/// Both `<folder>/` includes and nothing else of that room.
void expectOnlyBelow(const fs::path& folder, const std::string& room, const std::string& below) {
  for (const Include& include : includesBelow(source / folder)) {
    if (roomOf(include.target) != room) continue;
    EXPECT_TRUE(include.target.starts_with(below))
        << fs::relative(include.file, source).string() << ":" << include.line << " includes " << include.target;
  }
}

TEST(Architecture, TestsOfExercisesSeeTheTestingPartsAlone) {
  expectOnlyBelow("exercises", "course", "course/testing/");
  expectOnlyBelow("tests/hidden", "course", "course/testing/");
  expectOnlyBelow("tests/hidden", "grader", "grader/testing/");
}

TEST(Architecture, KernelsKnowNothingElseOfTheEngine) {
  expectOnlyBelow("framework/engine/kernels", "engine", "engine/kernels/");
}

TEST(Architecture, TheStudentsCommandNeedsWhatIsHandedOut) {
  // What the build leaves out of a student's tree stands in a folder of its own.
  for (const Include& include : includesBelow(source / "framework/app")) {
    const std::string room = roomOf(include.target);
    if (room != "grader" && room != "engine" && room != "lab") continue;
    EXPECT_EQ(include.file.parent_path().filename(), "instructor") << include.file << ":" << include.line;
  }
}

TEST(Architecture, ADemoStandsOnTheHarnessAlone) {
  for (const Include& include : includesBelow(source / "exercises")) {
    if (include.file.filename() != "demo.cpp") continue;
    const std::string room = roomOf(include.target);
    EXPECT_TRUE(room.empty() || room == "harness") << include.file << ":" << include.line << " " << include.target;
  }
}

TEST(Architecture, SolutionsIncludeTheirContractAlone) {
  for (const Include& include : includesBelow(source / "solutions")) {
    const std::string contract = include.file.stem().string() + ".h";
    const bool isStandard = include.target.find('.') == std::string::npos;
    EXPECT_TRUE(include.target == contract || isStandard || roomOf(include.target) == "harness" ||
                include.target.starts_with("Eigen/"))
        << include.file << ":" << include.line << " includes " << include.target;
  }
}

TEST(Architecture, IncludesAreSeen) {
  // Guards the tests above against a reader that sees nothing.
  EXPECT_EQ(includedBy("  #include \"grader/verdict.h\""), "grader/verdict.h");
  EXPECT_EQ(includedBy("# include <vector>  // why"), "vector");
  EXPECT_EQ(includedBy("#include\"a.h\""), "a.h");
  EXPECT_EQ(includedBy("// #include \"a.h\""), "");
  EXPECT_GT(includesBelow(source / "framework/course").size(), 50U);
  EXPECT_EQ(roomOf("grader/verdict.h"), "grader");
  EXPECT_EQ(roomOf("vector"), "");
}

}  // namespace

/// \file
/// Habits that the tests keep, read off their sources: none sleeps to wait for something, and none needs an exercise of
/// a certain name where any would do.

#include "base/file.h"
#include "course/manifest.h"
#include "folders.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// The files below tests/, without the folders that are about one exercise, without what plays a student's part, and
/// without this room, which names what it refuses.
std::vector<fs::path> sourcesOfTests() {
  std::set<std::string> apart = {"submissions", "hidden", "repository", "fixture"};
  for (const muelle::Manifest& exercise : muelle::readCourse(source / "exercises")) apart.insert(exercise.topic);
  const std::set<std::string> kinds = {".h", ".cpp", ".sh", ".txt"};
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(source / "tests"); entry != fs::end(entry); ++entry) {
    if (entry->is_directory() && apart.contains(entry->path().filename())) entry.disable_recursion_pending();
    if (entry->is_regular_file() && kinds.contains(entry->path().extension())) files.push_back(entry->path());
  }
  return files;
}

/// Every file that holds one of the words is named with it. \param reason completes "tests/x.cpp holds 'word': "
void expectNone(const std::vector<std::string>& words, const std::string& reason, const fs::path& except = {}) {
  for (const fs::path& file : sourcesOfTests()) {
    if (file == except) continue;
    const std::string text = muelle::readFile(file);
    for (const std::string& word : words) {
      EXPECT_EQ(text.find(word), std::string::npos)
          << fs::relative(file, source).string() << " holds '" << word << "': " << reason;
    }
  }
}

TEST(Tests, DoNotSleepToSynchronise) {
  expectNone({"sleep_for(", "sleep_until(", "usleep(", "nanosleep("},
             "wait for the condition with eventually() of tests/support/eventually.h",
             source / "tests/support/eventually.h");
}

TEST(Tests, AreNotNailedToOneExercise) {
  std::vector<std::string> words;
  for (const muelle::Manifest& exercise : muelle::readCourse(source / "exercises")) {
    for (const char* room : {"hidden_", "glue_", "public_", "solutions/", "\"solutions\" / \"", "submissions/"}) {
      words.push_back(room + exercise.topic);
    }
  }
  expectNone(words, "where any exercise would do, take the first of readCourse()");
}

TEST(Tests, AreSeen) { EXPECT_GT(sourcesOfTests().size(), 100U); }

}  // namespace

#include "tools.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

/// The course as its folders say: enough of a manifest to take a submission.
std::vector<Manifest> courseOfFolders(const std::filesystem::path& exercises) {
  std::vector<Manifest> course;
  for (const auto& entry : std::filesystem::directory_iterator(exercises)) {
    if (!std::filesystem::exists(entry.path() / "exercise.toml")) continue;
    Manifest manifest;
    manifest.topic = entry.path().filename().string();
    manifest.files = {manifest.topic + ".cpp"};
    course.push_back(manifest);
  }
  return course;
}

TEST(OwnFolders, TheSolutionsAndTheStubsAreSubmissions) {
  const std::filesystem::path root = MUELLE_SOURCE_FOLDER;
  const auto course = courseOfFolders(root / "exercises");
  ASSERT_FALSE(course.empty());
  for (const char* folder : {"solutions", "exercises"}) {
    const Submission s = takeSubmission(root / folder, course);
    EXPECT_EQ(s.sources.size(), course.size()) << folder;
    EXPECT_TRUE(s.refused.empty()) << folder;
    EXPECT_LE(s.notes.size(), course.size() + 1) << folder;
  }
}

}  // namespace
}  // namespace muelle::grader

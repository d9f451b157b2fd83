#include "grader/authoring/scaffold.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/manifest.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

const fs::path checkout = build_paths::source;

/// What is said, in one line, of a name that is refused.
std::string refusalOf(const std::string& topic) {
  try {
    scaffoldOf(checkout, topic);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ScaffoldName, IsOfLowerCaseWords) {
  for (const char* name : {"", "Spring", "2d", "a-b", "a b", "a/b", "..", "_a", "a_", "a__b", "é", "a\nb"}) {
    const std::string said = refusalOf(name);
    EXPECT_NE(said.find("is no name of an exercise"), std::string::npos) << name << ": " << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
  EXPECT_NE(refusalOf(std::string(41, 'a')), "");
  EXPECT_EQ(refusalOf("a_3d_spring"), "");
}

TEST(ScaffoldName, IsNotTaken) {
  const std::string taken = readCourse(checkout / "exercises").front().topic;
  EXPECT_EQ(refusalOf(taken), "exercises/" + taken + " exists already: take another name");
  EXPECT_EQ(refusalOf("hostile"), "tests/submissions/hostile exists already: take another name");
}

TEST(ScaffoldOrder, IsBehindTheLastExercise) {
  const TemporaryFolder folder(fs::path(build_paths::binary) / "test");
  const fs::path manifest = folder.path() / "exercises/swing/exercise.toml";
  fs::create_directories(manifest.parent_path());
  writeFile(manifest, scaffoldOf(checkout, "swing").at("exercises/swing/exercise.toml"));
  EXPECT_EQ(readManifest(manifest).order % 10, 0);
  EXPECT_GT(readManifest(manifest).order, readCourse(checkout / "exercises").back().order);
}

TEST(WriteScaffold, WritesAllFoldersOrNone) {
  const TemporaryFolder scratch(fs::path(build_paths::binary) / "test");
  const Tree files = scaffoldOf(checkout, "swing");
  writeScaffold(scratch.path(), "swing", files);
  for (const auto& [file, text] : files) EXPECT_EQ(readFile(scratch.path() / file), text) << file;

  for (const fs::path& folder : foldersOf("swing")) fs::remove_all(scratch.path() / folder);
  fs::remove_all(scratch.path() / "tests");
  writeFile(scratch.path() / "tests", "a file where a folder should be");
  EXPECT_ANY_THROW(writeScaffold(scratch.path(), "swing", files));
  EXPECT_FALSE(fs::exists(scratch.path() / "exercises/swing"));
}

}  // namespace
}  // namespace muelle::grader

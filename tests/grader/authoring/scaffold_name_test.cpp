#include "grader/authoring/scaffold.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/manifest.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

const fs::path source = build_paths::source;

/// What is said, in one line, of a name that is refused.
std::string refusalOf(const std::string& topic) {
  try {
    scaffoldOf(source, topic);
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
  const std::string taken = readCourse(source / "exercises").front().topic;
  EXPECT_EQ(refusalOf(taken), "exercises/" + taken + " exists already: take another name");
  EXPECT_EQ(refusalOf("hostile"), "tests/submissions/hostile exists already: take another name");
}

TEST(ScaffoldOrder, IsBehindTheLastExercise) {
  const TemporaryFolder folder(fs::path(build_paths::binary) / "test");
  const fs::path manifest = folder.path() / "exercises/swing/exercise.toml";
  fs::create_directories(manifest.parent_path());
  writeFile(manifest, scaffoldOf(source, "swing").at("exercises/swing/exercise.toml"));
  EXPECT_EQ(readManifest(manifest).order % 10, 0);
  EXPECT_GT(readManifest(manifest).order, readCourse(source / "exercises").back().order);
}

TEST(WriteScaffold, WritesAllFoldersOrNone) {
  const TemporaryFolder checkout(fs::path(build_paths::binary) / "test");
  const Tree files = scaffoldOf(source, "swing");
  writeScaffold(checkout.path(), "swing", files);
  for (const auto& [file, text] : files) EXPECT_EQ(readFile(checkout.path() / file), text) << file;

  for (const fs::path& folder : foldersOf("swing")) fs::remove_all(checkout.path() / folder);
  fs::remove_all(checkout.path() / "tests");
  writeFile(checkout.path() / "tests", "a file where a folder should be");
  EXPECT_ANY_THROW(writeScaffold(checkout.path(), "swing", files));
  EXPECT_FALSE(fs::exists(checkout.path() / "exercises/swing"));
}

}  // namespace
}  // namespace muelle::grader

#include "grader/authoring/handout.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

/// A tree of three files, written into scratch folders.
class WriteHandout : public testing::Test {
 protected:
  WriteHandout() {
    handout_.tree = {{"muelle", "#!/bin/sh\n"},
                     {"framework/course/handed_out.txt", "1 a\n"},
                     {"exercises/spring/spring.cpp", "// stub\n"}};
  }

  void write(const fs::path& folder, Replace replace = Replace::No) const {
    writeHandout(handout_, checkout_, folder, replace);
  }

  void expectRefused(const fs::path& folder, Replace replace, const std::string& why) const {
    try {
      write(folder, replace);
      ADD_FAILURE() << folder << " was written";
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(why), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }

  TemporaryFolder scratch_{fs::path(build_paths::binary) / "test"};
  fs::path checkout_ = scratch_.path() / "checkout";
  fs::path target_ = scratch_.path() / "a b" / "students";
  Handout handout_;
};

TEST_F(WriteHandout, MakesTheFolderAndAProgramOfTheLauncher) {
  write(target_);
  EXPECT_EQ(readFile(target_ / "exercises/spring/spring.cpp"), "// stub\n");
  EXPECT_EQ(access((target_ / "muelle").c_str(), X_OK), 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(target_.parent_path()), {}), 1) << "nothing is left beside it";
}

TEST_F(WriteHandout, FillsAnEmptyFolder) {
  fs::create_directories(target_);
  write(target_ / "");
  EXPECT_TRUE(fs::exists(target_ / "muelle"));
}

TEST_F(WriteHandout, LeavesOtherFoldersAlone) {
  fs::create_directories(target_);
  writeFile(target_ / "thesis.tex", "mine");
  expectRefused(target_, Replace::No, "is not empty and no student's tree");
  expectRefused(target_, Replace::Yes, "is not empty and no student's tree");
  EXPECT_EQ(readFile(target_ / "thesis.tex"), "mine");
  expectRefused(target_ / "thesis.tex", Replace::Yes, "is no folder");
}

TEST_F(WriteHandout, ReplacesAStudentsTreeWhenForcedAndKeepsItsHistory) {
  write(target_);
  fs::create_directories(target_ / ".git");
  writeFile(target_ / ".git/HEAD", "ref");
  writeFile(target_ / "exercises/spring/old.h", "gone from the course");
  expectRefused(target_, Replace::No, "--force");
  write(target_, Replace::Yes);
  EXPECT_EQ(readFile(target_ / ".git/HEAD"), "ref");
  EXPECT_FALSE(fs::exists(target_ / "exercises/spring/old.h"));
  EXPECT_EQ(std::distance(fs::directory_iterator(target_.parent_path()), {}), 1);
}

TEST_F(WriteHandout, KeepsOutOfTheCheckout) {
  expectRefused(checkout_, Replace::No, "lies in the checkout");
  expectRefused(checkout_ / "exercises/new", Replace::No, "lies in the checkout");
  write(checkout_ / "out/students");
  EXPECT_TRUE(fs::exists(checkout_ / "out/students/muelle"));
}

TEST_F(WriteHandout, WritesNothingWhereAFileCannotBeWritten) {
  handout_.tree["muelle/below"] = "a file is no folder";
  EXPECT_ANY_THROW(write(target_));
  EXPECT_FALSE(fs::exists(target_));
}

}  // namespace
}  // namespace muelle::grader

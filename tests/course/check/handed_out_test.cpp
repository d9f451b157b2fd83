#include "course/check/handed_out.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>
#include <cstdlib>

namespace muelle {
namespace {

namespace fs = std::filesystem;

/// A checkout of one exercise, with its list.
class HandedOut : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root_ / "framework/harness");
    fs::create_directories(root_ / "framework/course");
    fs::create_directories(root_ / "exercises/spring");
    writeFile(root_ / "framework/harness/types.h", "types\n");
    writeFile(root_ / "exercises/spring/spring.h", "double f();\n");
    writeFile(root_ / "exercises/spring/exercise.toml", "");
    writeFile(root_ / "framework/course/handed_out.txt", handedOutList(root_));
  }

  TemporaryFolder folder_{fs::path(build_paths::binary) / "test"};
  fs::path root_ = folder_.path();
};

TEST_F(HandedOut, NothingIsSaidOfWhatIsAsItWas) {
  EXPECT_TRUE(changedHandedOut(root_, "spring").empty());
  writeFile(root_ / "exercises/spring/spring.h", "double f();\r\n");
  EXPECT_TRUE(changedHandedOut(root_, "spring").empty()) << "a carriage return is a download's, not the student's";
}

TEST_F(HandedOut, AChangedOrMissingFileIsNamed) {
  writeFile(root_ / "exercises/spring/spring.h", "float f();\n");
  fs::remove(root_ / "framework/harness/types.h");
  EXPECT_EQ(changedHandedOut(root_, "spring"),
            (std::vector<std::string>{"exercises/spring/spring.h", "framework/harness/types.h"}));
  EXPECT_EQ(changedHandedOut(root_, "other"), std::vector<std::string>{"framework/harness/types.h"});
  EXPECT_EQ(changedHandedOut(root_).size(), 2U);
}

TEST_F(HandedOut, AStudentGetsItBackAndAnAuthorNotesIt) {
  const std::vector<std::string> changed = {"exercises/spring/spring.h"};
  EXPECT_EQ(sayChanged(root_, {}), "");
  EXPECT_TRUE(sayChanged(root_, changed).starts_with("exercises/spring/spring.h is not as it was handed out: get it"));
  fs::create_directories(root_ / "framework/grader");
  EXPECT_NE(sayChanged(root_, changed).find("note the change"), std::string::npos);
}

TEST(HandedOutList, IsCurrent) {
  const fs::path list = fs::path(MUELLE_SOURCE) / "framework/course/handed_out.txt";
  if (std::getenv("MUELLE_REFRESH_HANDED_OUT") != nullptr) writeFile(list, handedOutList(MUELLE_SOURCE));
  EXPECT_EQ(readFile(list), handedOutList(MUELLE_SOURCE))
      << "refresh it:  MUELLE_REFRESH_HANDED_OUT=1 build/tests/course/check/muelle_check_tests "
         "--gtest_filter=HandedOutList.*";
}

}  // namespace
}  // namespace muelle

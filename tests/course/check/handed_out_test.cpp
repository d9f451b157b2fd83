#include "course/check/handed_out.h"

#include "base/build_paths.h"
#include "base/file.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>

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
  EXPECT_EQ(sayChanged(root_, "spring"), "");
  writeFile(root_ / "exercises/spring/spring.h", "double f();\r\n");
  EXPECT_EQ(sayChanged(root_, "spring"), "") << "a carriage return is a download's, not the student's";
}

TEST_F(HandedOut, AChangedOrMissingFileIsNamed) {
  writeFile(root_ / "exercises/spring/spring.h", "float f();\n");
  fs::remove(root_ / "framework/harness/types.h");
  const std::string says = " is not as it was handed out: get it back, for you are graded against the original\n";
  const std::string harness = "framework/harness/types.h" + says;
  EXPECT_EQ(sayChanged(root_, "spring"), "exercises/spring/spring.h" + says + harness);
  EXPECT_EQ(sayChanged(root_, "other"), harness);
  EXPECT_EQ(sayChanged(root_), "exercises/spring/spring.h" + says + harness);
}

TEST_F(HandedOut, AStudentGetsItBackAndAnAuthorNotesIt) {
  writeFile(root_ / "exercises/spring/spring.h", "float f();\n");
  fs::create_directories(root_ / "framework/grader");
  EXPECT_NE(sayChanged(root_).find("get it back"), std::string::npos) << "an empty folder builds no grader";
  writeFile(root_ / "framework/grader/CMakeLists.txt", "");
  EXPECT_NE(sayChanged(root_).find("note the change"), std::string::npos);
}

TEST(HandedOutList, IsCurrent) {
  const fs::path list = fs::path(MUELLE_SOURCE) / "framework/course/handed_out.txt";
  if (std::getenv("MUELLE_REFRESH_HANDED_OUT") != nullptr) writeFile(list, handedOutList(MUELLE_SOURCE));
  EXPECT_EQ(readFile(list), handedOutList(MUELLE_SOURCE))
      << "refresh it:  MUELLE_REFRESH_HANDED_OUT=1 build/tests/course/check/muelle_check_tests "
         "--gtest_filter=HandedOutList.*";
}

/// The launcher decides before anything is built, and CMake before any of our code runs: neither can ask isAuthors().
TEST(Authors, AreToldFromStudentsByOneFile) {
  const auto mentions = [](const std::string& file) {
    const std::regex room("framework/(grader|app/instructor)(/[A-Za-z.]+)?");
    const std::string text = readFile(fs::path(MUELLE_SOURCE) / file);
    std::set<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), room), end; at != end; ++at) found.insert(at->str());
    return found;
  };
  const std::string mark = "framework/grader/CMakeLists.txt";
  EXPECT_EQ(mentions("muelle"), std::set{mark});
  EXPECT_EQ(mentions("framework/course/check/handed_out.cpp"), std::set{mark});
  EXPECT_TRUE(mentions("CMakeLists.txt").contains(mark));
}

}  // namespace
}  // namespace muelle

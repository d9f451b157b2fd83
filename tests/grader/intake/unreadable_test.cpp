/// \file
/// What this machine cannot read is no fault of the student's.

#include "tools.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace muelle::grader {
namespace {

/// Root reads everything: for these tests it becomes nobody.
class Unreadable : public ::testing::Test {
 protected:
  Unreadable() { ::chmod(folder_.path().c_str(), 0755); }
  ~Unreadable() override { becomeRoot(); }

  void forbid(const std::string& name) const { ASSERT_EQ(::chmod((folder_.path() / name).c_str(), 0), 0); }
  void allow(const std::string& name) const { ::chmod((folder_.path() / name).c_str(), 0755); }
  Submission take(const std::vector<std::string>& only = {}) const {
    if (::geteuid() == 0) {
      EXPECT_EQ(::seteuid(65534), 0);
    }
    Submission s = takeSubmission(folder_.path(), smallCourse(), {}, only);
    becomeRoot();
    return s;
  }

  TemporaryFolder folder_;

 private:
  static void becomeRoot() {
    if (::getuid() == 0) {
      EXPECT_EQ(::seteuid(0), 0);
    }
  }
};

TEST_F(Unreadable, AFileIsAFaultOfOurs) {
  folder_.write("spring_1d.cpp", "one");
  folder_.write("triangle.cpp", "two");
  forbid("spring_1d.cpp");
  const Submission s = take();
  EXPECT_EQ(s.faults.at("spring_1d"), "spring_1d.cpp cannot be read: Permission denied");
  EXPECT_FALSE(s.refused.contains("spring_1d"));
  EXPECT_FALSE(s.missing.contains("spring_1d"));
  EXPECT_TRUE(s.sources.contains("triangle"));
}

TEST_F(Unreadable, AFolderIsAFaultForWhatItMayHold) {
  folder_.write("spring_1d.cpp", "flat");
  folder_.write("triangle/triangle.cpp", "two");
  folder_.write("work/spring_1d/spring_1d.cpp", "better placed");
  forbid("work");
  const Submission s = take();
  allow("work");
  EXPECT_EQ(s.faults.at("spring_1d"), "work/, where spring_1d.cpp may lie, cannot be read: Permission denied");
  EXPECT_TRUE(s.sources.contains("triangle"));  // nothing in there would go before it
  EXPECT_TRUE(isNoted(s, "work/ cannot be read: Permission denied"));
}

TEST_F(Unreadable, AnExercisesFolderIsAFaultOfThatExercise) {
  folder_.write("triangle/triangle.cpp", "two");
  forbid("triangle");
  const Submission s = take();
  allow("triangle");
  EXPECT_TRUE(s.faults.contains("triangle"));
  EXPECT_EQ(s.missing.count("spring_1d"), 1u);
}

/// It can be listed and not entered.
TEST_F(Unreadable, TheFolderHandedInIsAFaultOfAll) {
  folder_.write("spring_1d.cpp", "one");
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0444), 0);
  const Submission s = take();
  ::chmod(folder_.path().c_str(), 0755);
  EXPECT_TRUE(s.faults.contains("spring_1d"));
  EXPECT_TRUE(s.faults.contains("triangle"));
  EXPECT_TRUE(isNoted(s, "the folder handed in cannot be read: Permission denied"));
}

TEST_F(Unreadable, AnArchiveInsideIsAFault) {
  writeArchive(folder_.path() / "work.zip", Format::Zip, {{"spring_1d.cpp", "one"}});
  forbid("work.zip");
  EXPECT_TRUE(take().faults.contains("spring_1d"));
}

TEST_F(Unreadable, JunkIsNone) {
  folder_.write("notes.txt", "");
  folder_.write("spring_1d.cpp", "one");
  folder_.write("triangle.cpp", "two");
  forbid("notes.txt");
  EXPECT_TRUE(take().faults.empty());
}

}  // namespace
}  // namespace muelle::grader

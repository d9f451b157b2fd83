/// \file
/// Hand-ins as servers give them out.

#include "tools.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

class Servers : public ::testing::Test {
 protected:
  Submission take(const std::string& name) const { return takeSubmission(folder_.path() / name, smallCourse()); }
  static void expectBoth(const Submission& s) {
    EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "one");
    EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
    EXPECT_TRUE(s.refused.empty());
    EXPECT_TRUE(s.missing.empty());
  }

  TemporaryFolder folder_;
};

TEST_F(Servers, MoodlesFolderHoldsFilesOrAnArchive) {
  for (const char* name : {"Ana García_12345_assignsubmission_file_", "Luis Pérez_7_assignsubmission_file"}) {
    folder_.write(std::string(name) + "/spring_1d.cpp", "one");
    writeArchive(folder_.path() / name / "rest.zip", Format::Zip, {{"work/triangle/triangle.cpp", "two"}});
    expectBoth(take(name));
  }
}

TEST_F(Servers, GradescopesFolderHoldsFlatFiles) {
  folder_.write("submission_98765/spring_1d.cpp", "one");
  folder_.write("submission_98765/triangle.cpp", "two");
  expectBoth(take("submission_98765"));
}

TEST_F(Servers, GitHubClassroomsFolderHoldsTheWholeHandout) {
  const std::string root = "springs-ana/";
  folder_.write(root + "exercises/spring_1d/spring_1d.cpp", "one");
  folder_.write(root + "exercises/triangle/triangle.cpp", "two");
  for (const char* file : {"README.md", "muelle", "CMakeLists.txt", ".git/config", "framework/harness/spring.h",
                           "framework/harness/probes.cpp", "exercises/triangle/demo.cpp"})
    folder_.write(root + file, "handed out");
  expectBoth(take("springs-ana"));
}

TEST_F(Servers, ABareSourceIsASubmission) {
  folder_.write("spring_1d.cpp", "one");
  folder_.write("Ana_12_assignsubmission_file_triangle.cpp", "two");
  EXPECT_EQ(take("spring_1d.cpp").sources.at("spring_1d").at("spring_1d.cpp"), "one");
  const Submission near = take("Ana_12_assignsubmission_file_triangle.cpp");
  EXPECT_EQ(near.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_EQ(near.taken.at("triangle"), "triangle.cpp is taken from 'Ana_12_assignsubmission_file_triangle.cpp'");
}

TEST_F(Servers, ABareSourceOfAnotherNameIsAskedAbout) {
  folder_.write("resorte.cpp", "one");
  EXPECT_EQ(take("resorte.cpp").missing.at("spring_1d"), "no spring_1d.cpp; is 'resorte.cpp' meant?");
}

TEST_F(Servers, ABareSourceHasTheLimitOfOne) {
  folder_.write("spring_1d.cpp", std::string(300'000, ' '));
  EXPECT_EQ(take("spring_1d.cpp").refused.at("spring_1d"), "spring_1d.cpp is larger than 256 KiB");
}

TEST_F(Servers, AnArchiveNamedAsASourceIsAnArchive) {
  writeArchive(folder_.path() / "work.cpp", Format::Zip, {{"spring_1d.cpp", "one"}, {"triangle.cpp", "two"}});
  expectBoth(take("work.cpp"));
}

}  // namespace
}  // namespace muelle::grader

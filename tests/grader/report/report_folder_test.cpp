#include "grader/report/report_folder.h"
#include "base/file.h"
#include "grader/report/report.h"
#include "sample.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

class ReportFolder : public ::testing::Test {
 protected:
  static std::string refusal(const std::function<void()>& body) {
    try {
      body();
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  TemporaryFolder temporary_{::testing::TempDir()};
  fs::path root_ = fs::canonical(temporary_.path());
};

TEST_F(ReportFolder, IsTheSameForTheSameSubmissionAndAnotherForAnother) {
  const fs::path ana = reportFolder(root_, "/a/ana");
  EXPECT_EQ(reportFolder(root_, "/a/ana/"), ana);
  EXPECT_NE(reportFolder(root_, "/b/ana"), ana);
  EXPECT_EQ(findReportFolder(root_, "/a/ana"), ana);
  EXPECT_EQ(findReportFolder(root_, "/c/ana"), std::nullopt);
}

TEST_F(ReportFolder, ThatIsNamedIsNoOtherSubmissions) {
  const fs::path out = root_ / "out";
  claim(out, "/a/ana");
  claim(out, "/a/ana");
  const std::string said = refusal([&] { claim(out, "/b/ben"); });
  EXPECT_NE(said.find("holds the reports of /a/ana: for those of /b/ben, give another folder"), std::string::npos)
      << said;
  EXPECT_THROW(requireOwn(out, "/b/ben"), std::invalid_argument);
  EXPECT_NO_THROW(requireOwn(root_ / "new", "/b/ben"));
}

TEST_F(ReportFolder, IsNeverInWhatIsHandedIn) {
  fs::create_directories(root_ / "class" / "ana");
  fs::create_directory_symlink(root_ / "class", root_ / "link");
  for (const char* out : {"class", "class/", "class/reports", "class/ana/out", "link/new", "other/../class/x"}) {
    EXPECT_THROW(requireOutside(root_ / out, root_ / "class"), std::invalid_argument) << out;
  }
  for (const char* out : {"", "out", "class2", "other"}) {
    EXPECT_NO_THROW(requireOutside(root_ / out, root_ / "class")) << out;
  }
  EXPECT_NO_THROW(requireOutside(root_, root_ / "hand-in.zip"));
  EXPECT_THROW(requireOutside("out", "."), std::invalid_argument) << "the default folder, typed in the class";
}

TEST_F(ReportFolder, OfALinkThatLeadsOutGetsNothing) {
  fs::create_directories(root_ / "elsewhere");
  fs::create_directories(root_ / "out");
  fs::create_directory_symlink(root_ / "elsewhere", root_ / "out" / "ana");
  EXPECT_NE(refusal([&] { reportFolder(root_ / "out", "/a/ana"); }).find("leads out"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(root_ / "elsewhere"));
}

TEST_F(ReportFolder, KeepsNoReportThatIsRemoved) {
  const fs::path out = reportFolder(root_, "/a/ana");
  writeReports(sampleSubmission(), out);
  removeReports(out);
  removeReports(out);
  EXPECT_FALSE(fs::exists(out / "results.json"));
  EXPECT_EQ(findReportFolder(root_, "/a/ana"), out);
}

}  // namespace
}  // namespace muelle::grader

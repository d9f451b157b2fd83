#include "full_disk.h"
#include "grader/report/report.h"
#include "sample.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace muelle::grader {
namespace {

class WriteReports : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "muelle_report_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path folder_;
};

TEST_F(WriteReports, WritesThreeFilesAndNothingElse) {
  const auto out = folder_ / "new" / "folder";
  writeReports(sampleSubmission(), out);
  EXPECT_EQ(read(out / "results.json"), resultsJson(sampleSubmission()));
  EXPECT_EQ(read(out / "results.xml"), junitXml(sampleSubmission()));
  EXPECT_EQ(read(out / "report.html"), htmlPage(sampleSubmission()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 3);
}

TEST_F(WriteReports, ReplacesALinkInsteadOfWritingThroughIt) {
  std::ofstream(folder_ / "precious") << "untouched";
  std::filesystem::create_symlink(folder_ / "precious", folder_ / "report.html");
  writeReports(sampleSubmission(), folder_);
  EXPECT_EQ(read(folder_ / "precious"), "untouched");
  EXPECT_FALSE(std::filesystem::is_symlink(folder_ / "report.html"));
}

TEST_F(WriteReports, RefusesAFolderThatIsALinkOutOfItsPlace) {
  std::filesystem::create_directories(folder_ / "elsewhere");
  std::filesystem::create_directories(folder_ / "out");
  const auto link = folder_ / "out" / "alice";
  std::filesystem::create_directory_symlink(folder_ / "elsewhere", link);
  for (const auto& out : {link, link / ""}) {
    try {
      writeReports(sampleSubmission(), out);
      ADD_FAILURE() << "wrote through a link";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("leads out of its folder"), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "elsewhere"));
}

TEST_F(WriteReports, WritesThroughALinkThatStaysInside) {
  std::filesystem::create_directories(folder_ / "2026");
  std::filesystem::create_directory_symlink("2026", folder_ / "latest");
  writeReports(sampleSubmission(), folder_ / "latest");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "2026" / "results.json"));
}

TEST_F(WriteReports, AFullDiskIsOneLineAndLeavesWhatWasThere) {
  writeReports(sampleSubmission(), folder_);
  GradedSubmission other = sampleSubmission();
  other.name = "another";
  {
    const FullDisk full(1000);
    try {
      writeReports(other, folder_);
      ADD_FAILURE() << "wrote onto a full disk";
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      EXPECT_TRUE(said.starts_with("cannot write " + (folder_ / "report.html").string() + ": ")) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos);
    }
  }
  EXPECT_EQ(read(folder_ / "results.json"), resultsJson(sampleSubmission()));
  EXPECT_EQ(read(folder_ / "report.html"), htmlPage(sampleSubmission()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 3);
}

TEST_F(WriteReports, LeavesNothingHalfWrittenWhenItFails) {
  std::filesystem::create_directories(folder_ / "report.html" / "in the way");
  EXPECT_THROW(writeReports(sampleSubmission(), folder_), std::runtime_error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(WriteReports, SaysWhereItCannotWrite) {
  std::ofstream(folder_ / "file") << "";
  try {
    writeReports(sampleSubmission(), folder_ / "file");
    FAIL() << "wrote into a file";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find((folder_ / "file").string()), std::string::npos);
  }
}

}  // namespace
}  // namespace muelle::grader

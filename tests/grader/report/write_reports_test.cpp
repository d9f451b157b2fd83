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

TEST_F(WriteReports, LeavesNothingHalfWrittenWhenItFails) {
  std::filesystem::create_directories(folder_ / "results.json" / "in the way");
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

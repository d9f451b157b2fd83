/// \file
/// Attacks that cannot be files of a repository: links, FIFOs, devices, archives, and sources of a size to choke on.
/// tests/grader/intake looks at what intake says of each; here the whole path must give no points and write nothing.

#include "grading.h"
#include "surroundings.h"
#include "tools.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/manifest.h"
#include "grader/record.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

class HostileIntake : public ::testing::Test {
 protected:
  HostileIntake() : surroundings_(course_ / "solutions") {}
  ~HostileIntake() override { EXPECT_EQ(surroundings_.changes(), ""); }

  fs::path source() const { return folder_.path() / file_; }
  void expectNothingFor(const fs::path& submission) const { expectDefeated(gradeAttack(submission, topic_), ""); }

  const fs::path course_ = build_paths::source;
  const std::string topic_ = readCourse(course_ / "exercises").front().topic;  // any would do
  const std::string file_ = topic_ + ".cpp";
  const fs::path solution_ = course_ / "solutions" / topic_ / file_;
  TemporaryFolder folder_;
  Surroundings surroundings_;
};

TEST_F(HostileIntake, SymbolicLinkToTheSolution) {
  fs::create_symlink(solution_, source());
  expectNothingFor(folder_.path());
}

TEST_F(HostileIntake, FolderThatIsALink) {
  fs::create_directory_symlink(solution_.parent_path(), folder_.path() / topic_);
  expectNothingFor(folder_.path());
}

/// A student links what the instructor alone may read.
TEST_F(HostileIntake, HardLinkToTheSolution) {
  std::error_code error;
  const TemporaryFolder instructors;
  fs::create_hard_link(instructors.write("copy.cpp", readFile(solution_)), source(), error);
  if (error) GTEST_SKIP() << "the file system makes no hard links";
  if (::chown(folder_.path().c_str(), 65534, 65534) != 0) GTEST_SKIP() << "only root gives a folder to a student";
  expectNothingFor(folder_.path());
}

/// The archive names a file of this machine as the source's other name.
TEST_F(HostileIntake, HardLinkOutOfAnArchive) {
  const fs::path archive = folder_.path() / "hand-in.tar";
  writeArchive(archive, Format::Tar, {{file_, "", S_IFREG, "", solution_}});
  expectNothingFor(archive);
}

TEST_F(HostileIntake, FifoThatNobodyFills) {
  ASSERT_EQ(mkfifo(source().c_str(), 0644), 0);
  expectNothingFor(folder_.path());
}

TEST_F(HostileIntake, EndlessDevice) {
  if (::mknod(source().c_str(), S_IFCHR | 0666, makedev(1, 5)) != 0) GTEST_SKIP() << "only root makes devices";
  expectNothingFor(folder_.path());
}

TEST_F(HostileIntake, SourceOf100Megabytes) {
  std::ofstream stream(source());
  stream << "#include \"" << topic_ << ".h\"\n";
  const std::string line(1 << 20, '/');
  for (int i = 0; i < 100; ++i) stream << line;
  stream.close();
  expectNothingFor(folder_.path());
}

TEST_F(HostileIntake, SparseSourceOfATerabyte) {
  const int sparse = open(source().c_str(), O_CREAT | O_WRONLY, 0644);
  ASSERT_GE(sparse, 0);
  if (ftruncate(sparse, 1L << 40) != 0) GTEST_SKIP() << "the file system has no files of that size";
  close(sparse);
  expectNothingFor(folder_.path());
}

TEST_F(HostileIntake, ArchiveThatClimbsOut) {
  const fs::path archive = folder_.path() / "hand-in.tar";
  const std::string text = readFile(solution_);
  writeArchive(archive, Format::Tar,
               {{"../dropped", text},
                {"/tmp/dropped", text},
                {"a/../../dropped", text},
                {"..", text},
                {"link", "", S_IFLNK, "/tmp"},
                {"link/dropped", text},
                {file_, "", S_IFLNK, solution_}});
  expectNothingFor(archive);
}

TEST_F(HostileIntake, ArchiveWithTwoEntriesOfOneName) {
  const fs::path archive = folder_.path() / "hand-in.zip";
  const std::string text = readFile(solution_);
  writeArchive(archive, Format::Zip, {{topic_ + "/" + file_, text}, {topic_ + "/" + file_, text + "\n"}});
  expectNothingFor(archive);
}

TEST_F(HostileIntake, NamesWithEscapesAndNewlinesAreTame) {
  const fs::path archive = folder_.path() / "hand-in.tar";
  writeArchive(archive, Format::Tar,
               {{"\x1b[2J\x1b]0;owned\x07.cpp", "x"},
                {"a\n" + topic_ + ": 10 of 10", "x"},
                {"=cmd|' /C calc'!A0", "x"},
                {"<script>alert(1)</script>", "x"},
                {"\xe2\x80\xae"
                 "ppc.x",
                 "x"},
                {file_, "#error \x1b[31m\n"}});
  expectNothingFor(archive);
}

/// A gzip file of many members is one stream: 10 GB of zeros in 10 MB.
TEST_F(HostileIntake, TenGigabytesOfZeros) {
  const fs::path member = folder_.path() / "member.gz";
  const fs::path archive = folder_.path() / "hand-in.tar.gz";
  const fs::path head = folder_.path() / "head";
  // The header of one entry of 10 GiB, as tar writes it for a sparse file.
  const fs::path zeros = folder_.path() / "zeros";
  std::ofstream(zeros).close();
  fs::resize_file(zeros, 10UL << 30);
  const std::string folder = folder_.path().string();
  const std::string command = "cd " + folder +
                              " && tar --format=gnu -cf - zeros | head -c 512 > head && gzip -1 < head > " +
                              archive.filename().string() + " && head -c 10485760 /dev/zero | gzip -9 > member.gz";
  ASSERT_EQ(std::system(command.c_str()), 0);
  fs::remove(zeros);
  const std::string packed = readFile(member);
  std::ofstream stream(archive, std::ios::app | std::ios::binary);
  for (int i = 0; i < 1025; ++i) stream << packed;
  stream.close();
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(gradeAttack(archive, topic_), std::runtime_error);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(HostileIntake, ManyEntries) {
  const fs::path archive = folder_.path() / "hand-in.tar";
  std::vector<ArchiveEntry> entries;
  for (int i = 0; i < 30'000; ++i) entries.push_back({"entry" + std::to_string(i), ""});
  entries.push_back({file_, readFile(solution_)});
  writeArchive(archive, Format::Tar, entries);
  expectNothingFor(archive);
}

}  // namespace
}  // namespace muelle::grader

#include "tools.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>
#include <chrono>

namespace muelle::grader {
namespace {

class Folder : public ::testing::Test {
 protected:
  Submission take(const IntakeLimits& limits = {}) const {
    return takeSubmission(folder_.path(), smallCourse(), limits);
  }
  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

using FolderLayout = Folder;
using FolderLinks = Folder;
using FolderSpecialFiles = Folder;
using FolderLimits = Folder;
using FolderNames = Folder;

TEST_F(FolderLayout, TakesTopicSlashFile) {
  folder_.write("spring_1d/spring_1d.cpp", "one");
  folder_.write("triangle/triangle.cpp", "two");
  const Submission s = take();
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "one");
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_TRUE(s.notes.empty());
  EXPECT_TRUE(s.refused.empty());
}

TEST_F(FolderLayout, TakesFlatFiles) {
  folder_.write("triangle.cpp", "two");
  const Submission s = take();
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
  EXPECT_FALSE(s.sources.contains("spring_1d"));
  EXPECT_FALSE(s.refused.contains("spring_1d"));
}

TEST_F(FolderLayout, LooksIntoEnclosingFolders) {
  folder_.write("My Hand-in (2)/exercises/spring_1d/spring_1d.cpp", "one");
  folder_.write("My Hand-in (2)/triangle.cpp", "two");
  const Submission s = take();
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp"), "one");
  EXPECT_EQ(s.sources.at("triangle").at("triangle.cpp"), "two");
}

/// The sentence: two candidates that differ, neither counts, both are named.
TEST_F(FolderLayout, RefusesTwoThatDifferWhereverTheyLie) {
  folder_.write("deep/deeper/spring_1d/spring_1d.cpp", "placed");
  folder_.write("spring_1d.cpp", "flat");
  folder_.write("triangle/triangle.cpp", "shallow");
  folder_.write("old/copy/triangle/triangle.cpp", "deep");
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_EQ(
      s.refused.at("spring_1d"),
      "spring_1d.cpp is there 2 times, and 'deep/deeper/spring_1d/spring_1d.cpp' and 'spring_1d.cpp' differ: hand "
      "in one, named spring_1d.cpp");
  EXPECT_NE(s.refused.at("triangle").find("'triangle/triangle.cpp' and 'old/copy/triangle/triangle.cpp' differ"),
            std::string::npos);
}

TEST_F(FolderLayout, RefusesTwoOfTheSameRank) {
  folder_.write("a/spring_1d/spring_1d.cpp", "one");
  folder_.write("b/spring_1d/spring_1d.cpp", "two");
  const Submission s = take();
  EXPECT_FALSE(s.sources.contains("spring_1d"));
  EXPECT_EQ(s.refused.at("spring_1d"),
            "spring_1d.cpp is there 2 times, and 'a/spring_1d/spring_1d.cpp' and 'b/spring_1d/spring_1d.cpp' differ: "
            "hand in one, named spring_1d.cpp");
}

TEST_F(FolderLayout, DoesNotTakeAFileFromAnotherExercisesFolder) {
  folder_.write("triangle/spring_1d.cpp", "misplaced");
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_TRUE(isNoted(s, "spring_1d.cpp"));
}

TEST_F(FolderLayout, IgnoresEverythingElseAndSaysSoBriefly) {
  folder_.write("spring_1d/spring_1d.cpp", "one");
  for (const char* name : {"CMakeLists.txt", "Eigen/Core", "cheat.h", "cheat.o", "second.cpp", "x.so"})
    folder_.write(std::string("spring_1d/") + name, "harm");
  for (const char* name : {"README.md", "spring_1d.h", "exercise.toml", "demo.cpp", "public_test.cpp"})
    folder_.write(std::string("spring_1d/") + name, "as handed out");
  const Submission s = take();
  EXPECT_EQ(s.sources.at("spring_1d").size(), 1u);
  EXPECT_EQ(s.notes,
            (std::vector<std::string>{
                "ignored 5 other files in spring_1d/: CMakeLists.txt, cheat.h, cheat.o, second.cpp, ...",
                "ignored in spring_1d/Eigen/: Core", "ignored 5 files that the course hands out; its own are used"}));
}

TEST_F(FolderLayout, SkipsHiddenFolders) {
  folder_.write(".git/spring_1d/spring_1d.cpp", "old");
  folder_.write("__MACOSX/spring_1d/spring_1d.cpp", "fork");
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_TRUE(isNoted(s, "ignored 2 hidden files or folders"));
}

TEST_F(FolderLayout, CopiesThatDifferInLineEndsAreEqual) {
  folder_.write("spring_1d.cpp", "one\ntwo\n");
  folder_.write("windows/spring_1d.cpp", "one\r\ntwo\r\n");
  const Submission s = take();
  EXPECT_TRUE(s.refused.empty());
  EXPECT_TRUE(s.sources.contains("spring_1d"));
}

TEST_F(FolderLayout, TakesAFileWhoseNameDiffersInCase) {
  folder_.write("Triangle.CPP", "two");
  EXPECT_TRUE(isNoted(take(), "triangle.cpp is taken from 'Triangle.CPP'"));
}

TEST_F(FolderLayout, KeepsBytesAsTheyAre) {
  const std::string bytes("int a;\r\n\xff\xfe", 10);
  folder_.write("spring_1d.cpp", bytes);
  EXPECT_EQ(take().sources.at("spring_1d").at("spring_1d.cpp"), bytes);
}

TEST_F(FolderLayout, IsNamedAfterTheFolder) {
  const std::string name = folder_.path().filename().string();
  EXPECT_EQ(takeSubmission(folder_.path().string() + "/", smallCourse()).name, name);
  EXPECT_EQ(take().name, name);
  EXPECT_EQ(take().path, folder_.path());
}

TEST_F(FolderLinks, RefusesASymbolicLinkInPlaceOfTheFile) {
  const auto secret = folder_.write("secret.txt", "secret");
  std::filesystem::create_directories(at("spring_1d"));
  std::filesystem::create_symlink(secret, at("spring_1d/spring_1d.cpp"));
  const Submission s = take();
  EXPECT_FALSE(s.sources.contains("spring_1d"));
  EXPECT_EQ(s.refused.at("spring_1d"), "spring_1d/spring_1d.cpp is a symbolic link");
}

TEST_F(FolderLinks, ALinkInPlaceIsNotReplacedByADeeperFile) {
  std::filesystem::create_symlink("/etc/passwd", at("spring_1d.cpp"));
  folder_.write("deeper/spring_1d.cpp", "one");
  EXPECT_EQ(take().refused.at("spring_1d"),
            "spring_1d.cpp is there 2 times, and 'spring_1d.cpp' (is a symbolic link) and 'deeper/spring_1d.cpp' "
            "differ: hand in one, named spring_1d.cpp");
}

TEST_F(FolderLinks, DoesNotFollowALinkToAFolder) {
  const TemporaryFolder outside;
  outside.write("spring_1d.cpp", "another's");
  std::filesystem::create_directory_symlink(outside.path(), at("spring_1d"));
  std::filesystem::create_directory_symlink(".", at("loop"));
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_TRUE(isNoted(s, "spring_1d (is a symbolic link)") || isNoted(s, "loop, spring_1d (is a symbolic link)"));
}

TEST_F(FolderLinks, AHardLinkIsAFileLikeAnyOther) {
  const TemporaryFolder outside;
  std::filesystem::create_hard_link(outside.write("backup.cpp", "one"), at("spring_1d.cpp"));
  EXPECT_EQ(take().sources.at("spring_1d").at("spring_1d.cpp"), "one");
}

/// On a machine that many use, a link would hand in what only the grader may read.
TEST_F(FolderLinks, RefusesAHardLinkToAnothersFile) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  const TemporaryFolder outside;
  std::filesystem::create_hard_link(outside.write("secret", "secret"), at("spring_1d.cpp"));
  ASSERT_EQ(::chown(folder_.path().c_str(), 65534, 65534), 0);
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_EQ(s.refused.at("spring_1d"), "spring_1d.cpp is a hard link to a file of another user: hand in a copy");
}

TEST_F(FolderSpecialFiles, DoesNotWaitForANamedPipe) {
  ASSERT_EQ(::mkfifo(at("spring_1d.cpp").c_str(), 0600), 0);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d.cpp is a named pipe");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(FolderSpecialFiles, RefusesADevice) {
  if (::mknod(at("spring_1d.cpp").c_str(), S_IFCHR | 0600, makedev(1, 5)) != 0)
    GTEST_SKIP() << "devices can only be made by root";
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d.cpp is a device");
}

TEST_F(FolderSpecialFiles, RefusesASocket) {
  const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  at("spring_1d.cpp").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(fd);
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d.cpp is a socket");
}

TEST_F(FolderSpecialFiles, AFolderWithTheFilesNameIsNoFile) {
  std::filesystem::create_directories(at("spring_1d.cpp"));
  EXPECT_TRUE(take().sources.empty());
}

TEST_F(FolderLimits, AFileMayHaveTheLimitAndNotOneByteMore) {
  IntakeLimits limits;
  limits.sourceBytes = 1024;
  folder_.write("spring_1d.cpp", std::string(1024, 'x'));
  folder_.write("triangle.cpp", std::string(1025, 'x'));
  const Submission s = take(limits);
  EXPECT_EQ(s.sources.at("spring_1d").at("spring_1d.cpp").size(), 1024u);
  EXPECT_EQ(s.refused.at("triangle"), "triangle.cpp is larger than 1 KiB");
  EXPECT_FALSE(s.sources.contains("triangle"));
}

TEST_F(FolderLimits, AHugeSparseFileCostsNothing) {
  folder_.write("spring_1d.cpp", "");
  ASSERT_EQ(::truncate(at("spring_1d.cpp").c_str(), 10'000'000'000), 0);
  EXPECT_EQ(take().refused.at("spring_1d"), "spring_1d.cpp is larger than 256 KiB");
}

TEST_F(FolderLimits, AnArchiveBeyondItIsRefusedAsOneAlone) {
  IntakeLimits limits;
  limits.archiveBytes = 1000;
  folder_.write("ana/triangle.cpp", "two");
  writeArchive(at("ana/work.zip"), Format::Tar, {{"spring_1d.cpp", "one"}});
  EXPECT_EQ(refusal(at("ana"), limits), refusal(at("ana/work.zip"), limits));
  EXPECT_EQ(refusal(at("ana"), limits), "the archive work.zip is larger than 1000 bytes: hand in the sources alone");
}

TEST_F(FolderLimits, LooksAtTheShallowFilesOfACrowdFirst) {
  IntakeLimits limits;
  limits.entries = 50;
  folder_.write("zz/spring_1d/spring_1d.cpp", "one");
  for (int i = 0; i < 60; ++i) folder_.write(fmt::format("zz/zz/junk_{}", i), "");
  const Submission s = take(limits);
  EXPECT_TRUE(s.sources.contains("spring_1d"));
  EXPECT_TRUE(isNoted(s, "only the first 50 entries were looked at"));
}

TEST_F(FolderLimits, NotesAreCounted) {
  IntakeLimits limits;
  limits.notes = 3;
  for (int i = 0; i < 8; ++i) folder_.write(fmt::format("folder_{}/junk", i), "");
  const Submission s = take(limits);
  ASSERT_EQ(s.notes.size(), 4u);
  EXPECT_EQ(s.notes.back(), "... and 5 more notes");
}

TEST_F(FolderLimits, DeepNestingEnds) {
  std::string name;
  for (int i = 0; i < 100; ++i) name += "d/";
  folder_.write(name + "spring_1d.cpp", "deep");
  const Submission s = take();
  EXPECT_TRUE(s.sources.empty());
  EXPECT_TRUE(isNoted(s, "too deep"));
  EXPECT_NE(s.refused.at("spring_1d").find("no spring_1d.cpp; ignored d/d/"), std::string::npos);
}

TEST_F(FolderNames, AreMadePrintable) {
  folder_.write("a\nb\x1b[31m\xff.txt", "");
  const Submission s = take();
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_EQ(s.notes[0], "ignored: a\\nb\\x1b[31m\\xff.txt");
}

TEST_F(FolderNames, ASubmissionThatIsNotThereIsOneLine) {
  const std::string line = refusal(at("nobody\n"));
  EXPECT_NE(line.find("nobody\\n: No such file"), std::string::npos) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace muelle::grader

#include "base/file.h"
#include "support/temporary.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace muelle {
namespace {

namespace fs = std::filesystem;

TEST(WriteFile, ReplacesAFileAndLeavesNothingBeside) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "a", "long first text");
  writeFile(folder.path() / "a", std::string("s\0x", 3));
  EXPECT_EQ(readFile(folder.path() / "a"), std::string("s\0x", 3));
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"a"});
}

TEST(WriteFile, TakesANameWithoutFolderAndAnEmptyText) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "empty", "");
  EXPECT_EQ(readFile(folder.path() / "empty"), "");
}

TEST(ReadFile, SaysWhichFileIsMissing) {
  try {
    readFile("/nowhere/at/all");
    FAIL() << "the file does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot read /nowhere/at/all: No such file or directory");
  }
}

#ifdef __linux__
/// Address 0 of a process is no memory: opening the file goes well, reading it does not.
TEST(ReadFile, SaysWhichFileBreaksOffWhileItIsRead) {
  EXPECT_EQ(tryReadFile("/proc/self/mem"), std::nullopt);
  EXPECT_THROW(readFile("/proc/self/mem"), std::runtime_error);
}
#endif

TEST(ReadFile, OfAFileThatMayNotBeThere) {
  const TemporaryFolder folder(::testing::TempDir());
  EXPECT_EQ(tryReadFile(folder.path() / "a"), std::nullopt);
  writeFile(folder.path() / "a", "x");
  EXPECT_EQ(tryReadFile(folder.path() / "a"), "x");
}

TEST(TemporaryFolder, VanishesWithItsScope) {
  fs::path path;
  {
    const TemporaryFolder folder(::testing::TempDir());
    path = folder.path();
    writeFile(path / "a", "x");
    EXPECT_TRUE(fs::exists(path));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(TemporaryFolder, IsCalledLikeNoOtherProcesss) {
  const TemporaryFolder folder(::testing::TempDir());
  EXPECT_EQ(folder.path().filename().string().find(std::to_string(::getpid())), std::string::npos);
}

TEST(TemporaryFolder, OfADeadProcessIsRemovedAndALivingOnesIsNot) {
  const TemporaryFolder parent(::testing::TempDir());
  const std::filesystem::path abandoned = parent.path() / ".work.17-0.tmp";
  std::filesystem::create_directory(abandoned);
  writeFile(abandoned / "record.json", "{}");
  const TemporaryFolder alive(parent.path());
  std::filesystem::create_directory(parent.path() / "other");
  removeAbandonedFolders(parent.path());
  EXPECT_TRUE(std::filesystem::exists(abandoned)) << "it is younger than ten minutes";
  removeAbandonedFolders(parent.path(), std::chrono::seconds(0));
  EXPECT_FALSE(std::filesystem::exists(abandoned));
  EXPECT_TRUE(std::filesystem::exists(alive.path()));
  EXPECT_TRUE(std::filesystem::exists(parent.path() / "other"));
}

TEST(TemporaryFolder, IsAnotherOneEachTime) {
  const TemporaryFolder a(::testing::TempDir());
  const TemporaryFolder b(::testing::TempDir());
  EXPECT_NE(a.path(), b.path());
}

}  // namespace
}  // namespace muelle

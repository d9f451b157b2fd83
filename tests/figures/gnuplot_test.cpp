#include "figures/gnuplot.h"
#include "base/file.h"

#include <gtest/gtest.h>
#include <cstdlib>

namespace muelle {
namespace {

std::string failure(const std::filesystem::path& folder, const std::vector<std::string>& scripts) {
  try {
    runGnuplot(folder, scripts);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Gnuplot, RunsScriptsInTheirFolder) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "a.gp", "set print 'a.txt'; print 1 + 1");
  writeFile(folder.path() / "b.gp", "set print 'b.txt'; print 2 + 2");
  runGnuplot(folder.path(), {"a.gp", "b.gp"});
  EXPECT_EQ(readFile(folder.path() / "a.txt"), "2\n");
  EXPECT_EQ(readFile(folder.path() / "b.txt"), "4\n");
}

TEST(Gnuplot, TellsItsWordsOnOneLine) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "a.gp", "set nonsense\n");
  const std::string text = failure(folder.path(), {"a.gp"});
  EXPECT_NE(text.find("gnuplot failed with status 1"), std::string::npos) << text;
  EXPECT_NE(text.find("nrecognized option"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(Gnuplot, SurvivesAFloodOfWords) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "a.gp",
            "do for [i=1:20000] { print 'a line of output that nobody reads' }\nset nonsense\n");
  EXPECT_LT(failure(folder.path(), {"a.gp"}).size(), 70000u);
}

TEST(Gnuplot, SaysWhatToInstallWhenItIsMissing) {
  const TemporaryFolder folder(::testing::TempDir());
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const std::string text = failure(folder.path(), {"a.gp"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(text.find("cannot start gnuplot"), std::string::npos) << text;
  EXPECT_NE(text.find("install"), std::string::npos) << text;
}

}  // namespace
}  // namespace muelle

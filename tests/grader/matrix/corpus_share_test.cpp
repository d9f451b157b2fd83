#include "grader/matrix/corpus_share.h"

#include "base/file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

/// Forty submissions of one file each, in two exercises.
class Corpus : public ::testing::Test {
 protected:
  Corpus() {
    for (int i = 0; i < 40; ++i) write(i, "double force() { return 1; }\n");
  }

  fs::path root() const { return folder_.path(); }
  fs::path submission(int i) const { return root() / (i % 2 == 0 ? "even" : "odd") / "wrong" / fmt::format("w{}", i); }
  void write(int i, const std::string& text) const {
    fs::create_directories(submission(i));
    writeFile(submission(i) / "force.cpp", text);
  }
  int taken(int every) const {
    const CorpusShare share(root(), every);
    const auto all = submissionsIn(root());
    return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const auto& path) { return share.takes(path); }));
  }

  TemporaryFolder folder_{fs::temp_directory_path()};
};

TEST_F(Corpus, NothingIsKnownAtFirst) { EXPECT_EQ(taken(4), 40); }

TEST_F(Corpus, OfKnownOnesAShareIsTaken) {
  rememberCorpus(root());
  EXPECT_EQ(taken(1), 40);
  EXPECT_GT(taken(4), 2);
  EXPECT_LT(taken(4), 20);
  EXPECT_EQ(taken(1000), 0);
}

TEST_F(Corpus, WhatIsChangedOrNewIsAlwaysTaken) {
  rememberCorpus(root());
  write(7, "double force() { return -1; }\n");
  write(41, "double force() { return 1; }\n");
  EXPECT_EQ(taken(1000), 2);
  const CorpusShare share(root(), 1000);
  EXPECT_TRUE(share.takes(submission(7)));
  EXPECT_TRUE(share.takes(submission(41)));
}

TEST_F(Corpus, AFileMoreOrAnotherNameIsAChange) {
  rememberCorpus(root());
  writeFile(submission(3) / "more.cpp", "\n");
  fs::rename(submission(4) / "force.cpp", submission(4) / "other.cpp");
  EXPECT_EQ(taken(1000), 2);
}

TEST_F(Corpus, ANewSubmissionDoesNotChangeTheShareOfTheOthers) {
  rememberCorpus(root());
  const int before = taken(4);
  write(42, "double force() { return 1; }\n");
  EXPECT_EQ(taken(4), before + 1);
}

TEST_F(Corpus, ABrokenListIsNamedWithItsLine) {
  writeFile(root() / "known.txt", "# head\nnonsense\n");
  try {
    const CorpusShare share(root(), 4);
    FAIL() << "nonsense was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("known.txt:2"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace muelle::grader

#include "lab/bench/record.h"

#include "base/file.h"

#include <gtest/gtest.h>

namespace muelle::bench {
namespace {

class RecordFile : public ::testing::Test {
 protected:
  TemporaryFolder folder{std::filesystem::path(::testing::TempDir()) / "muelle_record"};
  std::filesystem::path file = folder.path() / "runs.tsv";
};

TEST_F(RecordFile, KeepsWhatWasAdded) {
  {
    Record record(file, "program 1");
    EXPECT_EQ(record.find("a"), nullptr);
    record.add("a", {"1", "", "two\twords\n"});
  }
  const Record again(file, "program 1");
  ASSERT_NE(again.find("a"), nullptr);
  EXPECT_EQ(*again.find("a"), (Record::Fields{"1", "", "two words "}));
  EXPECT_EQ(again.found(), 1u);
}

TEST_F(RecordFile, ARunThatWasCutOffIsRunAgainAndTheOthersAreNot) {
  {
    Record record(file, "program 1");
    record.add("a", {"1"});
    record.add("b", {"22"});
  }
  const std::string whole = readFile(file);
  writeFile(file, whole.substr(0, whole.size() - 2));  // killed while it wrote "b\t22\n"
  {
    Record record(file, "program 1");
    EXPECT_NE(record.find("a"), nullptr);
    EXPECT_EQ(record.find("b"), nullptr);
    record.add("b", {"33"});
  }
  const Record again(file, "program 1");
  ASSERT_NE(again.find("b"), nullptr);
  EXPECT_EQ(again.find("b")->at(0), "33");
}

TEST_F(RecordFile, RunsOfAnotherProgramDoNotCount) {
  { Record(file, "program 1").add("a", {"1"}); }
  const Record other(file, "program 2");
  EXPECT_EQ(other.find("a"), nullptr);
  EXPECT_EQ(other.found(), 0u);
}

}  // namespace
}  // namespace muelle::bench

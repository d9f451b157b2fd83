#include "grader/record.h"

#include "base/file.h"
#include "full_disk.h"
#include "sample.h"

#include <gtest/gtest.h>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <limits>

namespace muelle::grader {
namespace {

class Record : public ::testing::Test {
 protected:
  /// The verdict after a journey through a file.
  std::optional<Verdict> travelled(const Verdict& v) const {
    writeRecord(v, file_);
    return readRecord(file_);
  }
  /// The record of `v` with one piece of its text replaced.
  std::optional<Verdict> tampered(const Verdict& v, const std::string& from, const std::string& to) const {
    writeRecord(v, file_);
    std::string text = readFile(file_);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at == std::string::npos) return std::nullopt;
    writeFile(file_, text.replace(at, from.size(), to));
    return readRecord(file_);
  }

  TemporaryFolder folder_{::testing::TempDir()};
  std::filesystem::path file_ = folder_.path() / "verdict.json";
};

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

TEST_F(Record, KeepsEveryBitOfEveryNumber) {
  const double nan = std::bit_cast<double>(0x7ff800000000beefULL);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double got : {0.1, -0.0, nan, -nan, infinity, -infinity, std::numeric_limits<double>::denorm_min()}) {
    Verdict v = verdict("HookeForce", 1, 1);
    v.tests[1].mismatches[0].got = got;
    v.tests[1].mismatches[0].expected = 1.0 / 3.0;
    const auto back = travelled(v);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(bits(back->tests[1].mismatches[0].got), bits(got));
    EXPECT_EQ(back->tests[1].mismatches[0].expected, 1.0 / 3.0);
    EXPECT_EQ(back->tests[1].mismatches[0].tolerance, 1e-12);
  }
}

TEST_F(Record, KeepsWhatWasComparedAndTheOutcome) {
  Verdict v = verdict("HookeForce", 0, 1);
  v.outcome = Outcome::NeverWritten;
  v.isConfirmed = true;
  Mismatch& m = v.tests[0].mismatches[0];
  m.label = "height";
  m.unit = "m";
  m.row = 2;
  m.col = 3;
  m.rows = 4;
  m.cols = 5;
  m.gotRows = 6;
  m.gotCols = 7;
  const auto back = travelled(v);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->outcome, Outcome::NeverWritten);
  EXPECT_TRUE(back->isConfirmed);
  const Mismatch& read = back->tests[0].mismatches[0];
  EXPECT_EQ(read.label, "height");
  EXPECT_EQ(read.expression, m.expression);
  EXPECT_TRUE(read.ofCall);
  EXPECT_EQ(read.call, m.call);
  EXPECT_EQ(read.unit, "m");
  EXPECT_EQ((std::vector<long>{read.row, read.col, read.rows, read.cols, read.gotRows, read.gotCols}),
            (std::vector<long>{2, 3, 4, 5, 6, 7}));
}

TEST_F(Record, KeepsWhatATestHasSeen) {
  Verdict v = verdict("HookeForce", 1, 1);
  v.tests[1].seen = {"springForce", "asked_too_often"};
  const auto back = travelled(v);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->tests[0].seen, SeenMistake());
  EXPECT_EQ(back->tests[1].seen, v.tests[1].seen);
}

TEST_F(Record, KeepsWhatAuthorsCompare) {
  Verdict v = verdict("HookeForce", 1, 1);
  FunctionEvidence& evidence = v.evidence["springForce"];
  evidence.answers = {{0xfedcba9876543210ULL, {0.1, std::numeric_limits<double>::infinity()}, 1e-12}};
  evidence.listed = {{"wrong_sign", 2}, {"threshold", 0}};
  const auto back = travelled(v);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->evidence, v.evidence);
}

TEST_F(Record, OfAnotherVersionIsAsIfAbsent) {
  const Verdict v = verdict("HookeForce", 1, 0);
  EXPECT_TRUE(travelled(v).has_value());
  EXPECT_FALSE(tampered(v, "\"version\": 9", "\"version\": 1"));
  EXPECT_FALSE(tampered(v, "\"version\": 9", "\"release\": 7"));
  EXPECT_FALSE(tampered(v, "\"outcome\": \"passed\"", "\"outcome\": \"splendid\""));
}

TEST_F(Record, ThatIsDamagedIsAsIfAbsent) {
  EXPECT_FALSE(readRecord(file_));
  Verdict v = verdict("HookeForce", 1, 1);
  EXPECT_FALSE(tampered(v, "\"got\": \"-2.5\"", "\"got\": \"much\""));
  writeRecord(v, file_);
  const std::string whole = readFile(file_);
  for (std::size_t end = 0; end + 1 < whole.size(); end += 7) {
    writeFile(file_, whole.substr(0, end));
    EXPECT_FALSE(readRecord(file_)) << end;
  }
  EXPECT_FALSE(readRecord(folder_.path())) << "a folder";
}

TEST_F(Record, OnAFullDiskThrowsAndLeavesTheOneBefore) {
  writeRecord(verdict("HookeForce", 1, 0), file_);
  {
    const FullDisk full(64);
    EXPECT_THROW(writeRecord(verdict("HookeForce", 0, 1), file_), std::runtime_error);
  }
  const auto back = readRecord(file_);
  ASSERT_TRUE(back.has_value());
  EXPECT_TRUE(back->passed());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

}  // namespace
}  // namespace muelle::grader

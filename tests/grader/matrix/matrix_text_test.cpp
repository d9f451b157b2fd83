#include "grader/matrix/matrix_text.h"

#include <gtest/gtest.h>
#include <sstream>

namespace {

using namespace muelle::grader;

muelle::Manifest titledManifest() {
  muelle::Manifest result;
  result.topic = "spring";
  result.title = "A spring";
  for (const char* suite : {"HookeForce", "HeldFast", "ZeroLength"}) {
    result.criteria.push_back({suite, suite, 1.0, false, "", {}});
  }
  return result;
}

MatrixRow row(MatrixRow::Kind kind, std::set<std::string> expected, std::set<std::string> lost) {
  MatrixRow result;
  result.kind = kind;
  result.name = "some";
  result.file = "some.cpp";
  result.expected.lost = std::move(expected);
  result.lost = std::move(lost);
  return result;
}

Mutant mutant(Mutant::Fate fate, const std::string& reason) {
  Mutant result;
  result.mutation = mutations("a + b;").front();
  result.fate = fate;
  result.reason = reason;
  return result;
}

TEST(KillMatrix, RowIsExactOrNot) {
  MatrixRow exact = row(MatrixRow::Kind::Wrong, {"HookeForce"}, {"HookeForce"});
  EXPECT_TRUE(exact.exact());
  exact.named = {"wrong_sign"};
  EXPECT_FALSE(exact.exact());
  exact.expected.named = {"wrong_sign"};
  EXPECT_TRUE(exact.exact());
  exact.trouble = "does not compile";
  EXPECT_FALSE(exact.exact());
  EXPECT_FALSE(row(MatrixRow::Kind::Wrong, {"HookeForce"}, {}).exact());
  EXPECT_FALSE(row(MatrixRow::Kind::Right, {}, {"HookeForce"}).exact());
}

TEST(KillMatrix, AllMeansNoPartialPointEither) {
  MatrixRow zero = row(MatrixRow::Kind::Wrong, {}, {"HookeForce", "HeldFast", "ZeroLength"});
  zero.expected = noPoints(titledManifest());
  EXPECT_TRUE(zero.exact());
  zero.points = 0.5;
  EXPECT_FALSE(zero.exact());
}

TEST(KillMatrix, MutantNeedsItsReasonAndNoOther) {
  EXPECT_TRUE(mutant(Mutant::Fate::Killed, "").asStated());
  EXPECT_TRUE(mutant(Mutant::Fate::NotCompilable, "").asStated());
  EXPECT_FALSE(mutant(Mutant::Fate::Survived, "").asStated());
  EXPECT_TRUE(mutant(Mutant::Fate::Survived, "equivalent").asStated());
  EXPECT_FALSE(mutant(Mutant::Fate::Killed, "equivalent").asStated());
  EXPECT_FALSE(mutant(Mutant::Fate::NotCompilable, "equivalent").asStated());
}

TEST(KillMatrix, SummaryCounts) {
  TopicMatrix matrix;
  matrix.manifest = titledManifest();
  matrix.rows = {row(MatrixRow::Kind::Right, {}, {"HookeForce"}),
                 row(MatrixRow::Kind::Wrong, {"HookeForce"}, {"HookeForce"})};
  matrix.rows[1].expected.named = {"wrong_sign"};
  matrix.rows[1].named = {"wrong_sign", "halved"};
  matrix.mutants = {mutant(Mutant::Fate::Killed, ""), mutant(Mutant::Fate::NotCompilable, ""),
                    mutant(Mutant::Fate::Survived, "equivalent"), mutant(Mutant::Fate::Survived, "")};
  matrix.staleSurvivors = {"gone"};
  const MatrixSummary sum = summarise({matrix});
  EXPECT_EQ(sum.rows, 2);
  EXPECT_EQ(sum.exactRows, 0);
  EXPECT_EQ(sum.falseRejections, 1);
  EXPECT_EQ(sum.misconceptions, 1);
  EXPECT_EQ(sum.named, 0) << "a wrong name beside the right one is no right name";
  EXPECT_EQ(sum.wronglyNamed, 1);
  EXPECT_EQ(sum.killed, 1);
  EXPECT_EQ(sum.notCompilable, 1);
  EXPECT_EQ(sum.survivedWithReason, 1);
  EXPECT_EQ(sum.survivedWithout, 1);
  EXPECT_EQ(sum.staleSurvivors, 1);
  EXPECT_FALSE(matrix.good());
}

TEST(KillMatrix, ColumnsHaveDifferentCodes) {
  EXPECT_EQ(columnCodes(titledManifest()), (std::vector<std::string>{"HF", "HF2", "ZL"}));
}

TEST(KillMatrix, MarksWhatIsOtherwise) {
  TopicMatrix matrix;
  matrix.manifest = titledManifest();
  matrix.rows = {row(MatrixRow::Kind::Wrong, {"HookeForce", "HeldFast"}, {"HookeForce", "ZeroLength"})};
  matrix.mutants = {mutant(Mutant::Fate::Survived, "")};
  const std::string text = matrixText(matrix);
  EXPECT_NE(text.find(" x   .!  x!\n"), std::string::npos) << text;
  EXPECT_NE(text.find("some.cpp:1: passes HeldFast unexpectedly; loses ZeroLength unexpectedly\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("survives without a reason"), std::string::npos) << text;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(KillMatrix, IsNotGoodWhereTwoMistakesAreOne) {
  TopicMatrix matrix;
  matrix.manifest = titledManifest();
  EXPECT_TRUE(matrix.good());
  matrix.mistakesNotToldApart = {"rope and halved of springForce give the same numbers in every call"};
  EXPECT_FALSE(matrix.good());
  EXPECT_NE(matrixText(matrix).find("  ! of the listed mistakes: rope and halved of springForce give"),
            std::string::npos)
      << "without mutants, too";
}

TEST(KillMatrix, CsvHasALineACriterion) {
  TopicMatrix matrix;
  matrix.manifest = titledManifest();
  matrix.rows = {row(MatrixRow::Kind::Wrong, {"HookeForce"}, {"HookeForce"})};
  EXPECT_EQ(matrixCsv({matrix}),
            "topic,kind,name,criterion,expected,observed,misconceptions\n"
            "spring,wrong,some,HookeForce,lost,lost,\n"
            "spring,wrong,some,HeldFast,passed,passed,\n"
            "spring,wrong,some,ZeroLength,passed,passed,\n");
}

}  // namespace

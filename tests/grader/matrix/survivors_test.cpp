#include "grader/matrix/survivors.h"

#include "base/file.h"
#include "grader/record.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <algorithm>
#include <stdexcept>

namespace {

using muelle::writeFile;
using muelle::grader::Mutation;
using muelle::grader::mutations;
using muelle::grader::readSurvivors;
using muelle::grader::Survivor;

class SurvivorList : public ::testing::Test {
 protected:
  ~SurvivorList() override { std::filesystem::remove(file_); }

  std::vector<Survivor> read(const std::string& content) {
    writeFile(file_, content);
    return readSurvivors(file_, "mutants.toml").listed;
  }

  std::string reason(const std::string& content) {
    writeFile(file_, content);
    return readSurvivors(file_, "mutants.toml").any;
  }

  std::string complaint(const std::string& content) {
    try {
      read(content);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  }

 private:
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("survivors_" + std::to_string(getpid()) + ".toml");
};

TEST_F(SurvivorList, FindsItsMutationAgain) {
  const std::string source = "void f() {\n  if (L <= 0) return;\n}\n";
  const auto all = mutations(source);
  const auto found = std::find_if(all.begin(), all.end(), [](const Mutation& m) { return m.replacement == "<"; });
  ASSERT_NE(found, all.end());
  std::string entry = muelle::grader::survivorEntry(*found);
  entry.replace(entry.find("\"\""), 2, "\"a length is never negative\"");
  const std::vector<Survivor> survivors = read(entry);
  ASSERT_EQ(survivors.size(), 1u);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [&](const Mutation& m) { return survivors[0].matches(m); }), 1);
  EXPECT_TRUE(survivors[0].matches(*found));
  EXPECT_EQ(survivors[0].reason, "a length is never negative");
}

TEST_F(SurvivorList, OfNoFileIsEmpty) {
  EXPECT_TRUE(readSurvivors("/nowhere/mutants.toml", "mutants.toml").listed.empty());
}

TEST_F(SurvivorList, MayHaveOneReasonForAny) {
  EXPECT_TRUE(read("any = 'another right answer'\n").empty());
  EXPECT_EQ(reason("any = 'another right answer'\n"), "another right answer");
  EXPECT_EQ(reason("[[survivor]]\nline = 'a'\nmutation = 'b'\nreason = 'c'\n"), "");
  EXPECT_EQ(readSurvivors("/nowhere/mutants.toml", "mutants.toml").any, "");
}

TEST_F(SurvivorList, NeedsAReason) {
  EXPECT_EQ(complaint("[[survivor]]\nline = 'a'\nmutation = 'b'\n"),
            "mutants.toml:1: key 'reason': missing in [[survivor]]");
  EXPECT_EQ(complaint("[[survivor]]\nline = 'a'\nmutation = 'b'\nreason = ''\n"),
            "mutants.toml:4: key 'reason': is empty");
}

TEST_F(SurvivorList, ThatIsNoTomlIsNamedAsItIsShown) {
  EXPECT_TRUE(complaint("any = 'a'\nany = 'b'\n").starts_with("mutants.toml:2: "))
      << complaint("any = 'a'\nany = 'b'\n");
}

TEST_F(SurvivorList, RefusesWhatItDoesNotKnow) {
  EXPECT_TRUE(complaint("[[survivor]]\nlines = 'a'\n").starts_with("mutants.toml:2: key 'lines': unknown"));
  EXPECT_TRUE(complaint("[[mutant]]\nline = 'a'\n").starts_with("mutants.toml:1: key 'mutant'"));
  EXPECT_TRUE(complaint("[[survivor]\n").find(".toml:1: ") != std::string::npos);
  EXPECT_TRUE(
      complaint("[[survivor]]\nline='a'\nmutation='b'\nreason='c'\noccurrence=0\n").starts_with("mutants.toml:5: "));
}

}  // namespace

#include "grader/authoring/lint.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "grader/authoring/lint_contract.h"
#include "grader/authoring/scaffold.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

/// A new exercise in a course of its own, to be spoilt.
class Lint : public testing::Test {
 protected:
  Lint() {
    for (const auto& [file, text] : scaffoldOf(build_paths::source, "swing")) {
      fs::create_directories((course_.path() / file).parent_path());
      writeFile(course_.path() / file, text);
    }
  }

  void replace(const std::string& file, const std::string& old, const std::string& now) const {
    std::string text = readFile(course_.path() / file);
    const std::size_t place = text.find(old);
    ASSERT_NE(place, std::string::npos) << file << " has no " << old;
    writeFile(course_.path() / file, text.replace(place, old.size(), now));
  }

  bool tells(const std::string& words) const {
    return std::ranges::any_of(lintFiles(course_.path(), "swing"), [&](const Finding& finding) {
      return finding.text().find(words) != std::string::npos && finding.text().find('\n') == std::string::npos;
    });
  }

  /// Only the spoilt exercise is told of.
  void expectTold(const std::string& words) const { EXPECT_TRUE(tells(words)) << words; }

  TemporaryFolder course_{fs::path(build_paths::binary) / "test"};
  const std::string exercise_ = "exercises/swing/";
  const std::string wrong_ = "tests/submissions/swing/wrong/";
};

TEST_F(Lint, AScaffoldLacksWhatItsAuthorHasToWrite) {
  expectTold("exercises/swing/README.md:3: still to be written");
  expectTold("exercise.toml: 1 criterion; make it 5 to 15");
  expectTold("public_test.cpp: one suite only");
  expectTold("tests/submissions/swing/right: 1 submission; write 2 at least");
  expectTold("wrong/wrong_sign: is not known to come out as stated; ./muelle test-the-tests swing --remember");
  expectTold("sentences.txt: is missing");
  for (const char* words : {"no unit", "no range", "no docstring", "does not show", "no wrong submission"}) {
    EXPECT_FALSE(tells(words)) << words;
  }
}

TEST_F(Lint, AMissingFileIsNamed) {
  fs::remove(course_.path() / "tests/hidden/swing/oracle.cpp");
  fs::remove(course_.path() / (exercise_ + "README.md"));
  expectTold("tests/hidden/swing/oracle.cpp: is missing");
  expectTold("exercises/swing/README.md: is missing");
}

TEST_F(Lint, AStatementNeedsItsFigure) {
  replace(exercise_ + "README.md", "](figure.svg)", "](picture.svg)");
  expectTold("README.md: does not show figure.svg");
  fs::remove(course_.path() / (exercise_ + "figure.svg"));
  expectTold("figure.svg: is missing");
}

TEST_F(Lint, AHintIsNotEmpty) {
  replace(exercise_ + "exercise.toml", "The force is proportional to x and points back to the origin.", " ");
  expectTold("hint");
}

TEST_F(Lint, APointlessCriterionIsToldWithItsLine) {
  replace(exercise_ + "exercise.toml", "suite = \"Force\"\npoints = 10", "suite = \"Force\"\npoints = 0");
  expectTold("exercise.toml:");
  expectTold("points");
}

TEST_F(Lint, AManifestThatCannotBeReadIsToldInOneLineBeforeAnythingIsBuilt) {
  EXPECT_TRUE(lintManifests(course_.path()).empty());
  replace(exercise_ + "exercise.toml", "points = 10", "point = 10");
  const std::vector<Finding> unknown = lintManifests(course_.path());
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_TRUE(unknown[0].where.starts_with("exercises/swing/exercise.toml:")) << unknown[0].where;
  EXPECT_NE(unknown[0].what.find("point"), std::string::npos) << unknown[0].what;
  expectTold("exercises/swing/exercise.toml:");
  writeFile(course_.path() / (exercise_ + "exercise.toml"), "title = 3 4\n");
  ASSERT_EQ(lintManifests(course_.path()).size(), 1U);
  EXPECT_EQ(lintManifests(course_.path())[0].where, "exercises/swing/exercise.toml:1");
}

TEST_F(Lint, TwoExercisesOfOneOrderAreTold) {
  fs::copy(course_.path() / "exercises/swing", course_.path() / "exercises/other", fs::copy_options::recursive);
  const std::vector<Finding> same = lintManifests(course_.path());
  ASSERT_EQ(same.size(), 1U);
  EXPECT_NE(same[0].what.find("have the same order"), std::string::npos) << same[0].what;
}

TEST_F(Lint, AFunctionIsOneOfTheContract) {
  replace(exercise_ + "exercise.toml", "functions = [\"swingForce\"]", "functions = [\"swingFroce\"]");
  expectTold("criterion Force names swingFroce, which the contract does not have");
}

TEST_F(Lint, EveryMistakeAndEveryCriterionIsShownByAWrongSubmission) {
  fs::remove_all(course_.path() / (wrong_ + "wrong_sign"));
  expectTold("no wrong submission shows wrong_sign");
  expectTold("no wrong submission loses Force");
  fs::remove_all(course_.path() / (wrong_ + "zero"));
  expectTold("wrong/zero: is missing");
}

TEST_F(Lint, AFirstLineStatesWhatIsLost) {
  replace(wrong_ + "wrong_sign/swing.cpp", "// loses: Force", "// loses: Froce");
  expectTold("did you mean 'Force'");
  expectTold("wrong/wrong_sign/swing.cpp:1: no suite");  // its place once
}

/// What is said of a contract of one function.
std::vector<Finding> contractFindings(const std::string& docstring, const std::string& ranges) {
  return lintContract(docstring + "double f(const Vec3& xa, double k);\n" + ranges + "MUELLE_FUNCTIONS(f)\n", "f.h");
}

TEST(LintContract, AsksForUnitsAndRanges) {
  const std::string good = "/// Force [N] on a.\n/// \\param xa position [m]\n";
  EXPECT_TRUE(contractFindings(good, "MUELLE_RANGE(k, 1, 2)  // N/m\n").empty());
  EXPECT_TRUE(contractFindings(good + "/// \\param k stiffness [N/m]\n", "MUELLE_RANGE(k, 1, 2)\n").empty());
  const auto only = [](const std::vector<Finding>& findings) {
    return findings.size() == 1 ? findings[0].where + " " + findings[0].what : std::to_string(findings.size());
  };
  EXPECT_EQ(only(contractFindings(good, "MUELLE_RANGE(k, 1, 2)\n")), "f.h:3 k has no unit");
  EXPECT_EQ(only(contractFindings(good + "/// \\param k stiffness [N/m]\n", "")), "f.h:4 k has no range");
  EXPECT_EQ(only(contractFindings("/// Force on a.\n\n/// Force of xa [m].\n", "MUELLE_RANGE(k, 1, 2)  // N/m\n")),
            "0");
  EXPECT_EQ(only(contractFindings("/// xa is in metres: [m].\n\n", "MUELLE_RANGE(k, 1, 2)  // N/m\n")),
            "f.h:3 f has no docstring");
  EXPECT_EQ(only(contractFindings("/// A sum.\n", "MUELLE_RANGE(k, 1, 2)  // N/m\n/// xa [m]\n")),
            "f.h:2 the docstring of f has no unit");
}

TEST(LintContract, TakesAUnitFromWhatIsSaidOfTheArgumentAlone) {
  const auto linted = [](const std::string& docstring) {
    std::string text;
    for (const Finding& finding :
         lintContract(docstring + "double g(double m, double k);\nMUELLE_RANGE(m, 1, 2)\nMUELLE_RANGE(k, 1, 2)\n"
                                  "MUELLE_FUNCTIONS(g)\n",
                      "g.h")) {
      text += finding.where + " " + finding.what + "\n";
    }
    return text;
  };
  EXPECT_EQ(linted("/// Force [N].\n/// \\param m mass [kg]\n/// \\param k stiffness\n///   of the spring [N/m]\n"),
            "");
  EXPECT_EQ(linted("/// Force [N] of a mass m [kg] on a spring of k [N/m].\n"), "");
  EXPECT_EQ(linted("/// Force [N].\n/// \\param m mass\n/// \\param k stiffness [N/m]\n"), "g.h:4 m has no unit\n")
      << "the next argument's unit is not this one's";
  EXPECT_EQ(linted("/// Length [m].\n/// \\param k stiffness [N/m]\n"), "g.h:3 m has no unit\n") << "[m] is metres";
  EXPECT_EQ(linted("/// Force.\n/// \\param m mass [kg]\n/// \\param k stiffness [N/m]\n"),
            "g.h:4 the docstring of g has no unit\n");
}

/// This very course: what its files say. `muelle lint` runs its tests, too, which others do here; among them the
/// matrix, which grades whatever is not known yet.
TEST(CourseLint, FindsNothing) {
  const fs::path checkout = build_paths::source;
  for (const Manifest& exercise : readCourse(checkout / "exercises")) {
    for (const Finding& finding : lintFiles(checkout, exercise.topic)) {
      if (!finding.what.starts_with("is not known")) ADD_FAILURE() << finding.text();
    }
  }
}

}  // namespace
}  // namespace muelle::grader

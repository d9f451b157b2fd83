#include "grader/authoring/leaks.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/manifest.h"
#include "grader/authoring/handout.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

const fs::path source = build_paths::source;

/// What is withheld, read off a small course.
class Leaks : public testing::Test {
 protected:
  Leaks() {
    withheld_.functions["springForce"] = "exercises/spring/spring.cpp";
    withheld_.sentences["a stretched spring pulls its nodes together"] = "tests/hidden/spring/spring_test.cpp";
    withheld_.numbers["0.858375"] = "tests/hidden/spring/spring_test.cpp";
    withheld_.types["WorkerProcess"] = "framework/grader/remote/worker_process.h";
    for (const Expression& answer : expressionsOf(tokenise("double f() { return -k * (L - L0) * (xa - xb) / L; }"))) {
      withheld_.plain[answer.plain] = withheld_.shapes[answer.shape] = "solutions/spring/spring.cpp";
    }
  }

  std::vector<Leak> in(const std::string& file, const std::string& text) const {
    return findLeaks({{file, text}}, withheld_, {"/srv/course"});
  }

  void expectOne(const std::string& file, const std::string& text, const std::string& what) const {
    const std::vector<Leak> leaks = in(file, text);
    ASSERT_EQ(leaks.size(), 1U) << text;
    EXPECT_NE(leaks[0].text().find(what), std::string::npos) << leaks[0].text();
  }

  Withheld withheld_;
};

TEST_F(Leaks, AnAnswerIsFound) {
  expectOne("exercises/a/demo.cpp", "\nconst Vec3 f = -k * (L - L0) * (xa - xb) / L;\n",
            "exercises/a/demo.cpp:2 answers");
}

TEST_F(Leaks, AnAnswerInOtherNamesIsFound) {
  expectOne("exercises/a/demo.cpp", "f += -s * (r - rest) * (p - q) / r;", "in other names");
  EXPECT_TRUE(in("exercises/a/demo.cpp", "f = -s * (r - rest) * (p - q) / rest;").empty()) << "another formula";
}

TEST_F(Leaks, AFunctionThatStudentsWriteStandsInItsStubAlone) {
  const std::string text = "Vec3 springForce(const Vec3& a) {\n  return a;\n}\n";
  EXPECT_TRUE(in("exercises/spring/spring.cpp", text).empty());
  EXPECT_TRUE(in("exercises/a/demo.cpp", "const Vec3 f = submission::springForce(x);").empty());
  EXPECT_TRUE(in("exercises/spring/spring.h", "Vec3 springForce(const Vec3& a);").empty());
  expectOne("framework/harness/probes.cpp", text, "defines springForce");
}

TEST(Bodies, AreFoundWithShortLinesAndOtherNames) {
  Withheld withheld;
  const std::string body =
      "for (Node& {0} : nodes) {0}.F = zero(); for (Spring& {1} : springs) {{ {1}.calcForce(); "
      "{1}.na->F += {1}.F; {1}.nb->F -= {1}.F; }}";
  for (const Expression& found : bodiesOf(tokenise("void f() {" + fmt::format(fmt::runtime(body), "n", "s") + "}"))) {
    withheld.bodies.emplace(found.shape, "solutions/a/a.cpp");
  }
  const Tree tree = {{"exercises/a/a.cpp", "void f() const { " + fmt::format(fmt::runtime(body), "node", "b") + " }"}};
  const std::vector<Leak> leaks = findLeaks(tree, withheld, {});
  ASSERT_EQ(leaks.size(), 1U);
  EXPECT_EQ(leaks.front().text(), "exercises/a/a.cpp:1 answers an exercise: the function is one of solutions/a/a.cpp");
}

TEST_F(Leaks, WordsAndNumbersOfHiddenTestsAreFound) {
  expectOne("README.md", "So a stretched spring pulls its nodes together.", "has a sentence of tests/hidden");
  expectOne("exercises/a/public_test.cpp", "f(0.858375);", "has the number 0.858375");
}

TEST_F(Leaks, NamesOfTheInstructorsRoomsAreFoundInComments) {
  expectOne("framework/base/file.h", "/// As WorkerProcess does.", "names WorkerProcess");
  EXPECT_TRUE(in("framework/base/file.h", "class WorkerProcess;  // WorkerProcess is ours").empty());
}

TEST_F(Leaks, FilesAndPathsAreFound) {
  expectOne("solutions/spring/spring.cpp", "", "is no student's");
  expectOne("CMakePresets.json", "\"binaryDir\": \"/srv/course/build\"", "path of this machine");
}

TEST_F(Leaks, AScaffoldIsNotHandedOut) {
  expectOne("exercises/a/README.md", "# A\n<!-- WRITE: the mathematics -->\n",
            "exercises/a/README.md:2 is still to be written");
}

TEST(OwnNumbers, HaveAFractionAndFourDigitsThatCount) {
  for (const char* number : {"0.858375", "12.34", "1.2345e-3"}) EXPECT_TRUE(isOwnNumber(number)) << number;
  for (const char* number : {"100.0", "9.81", "0.0025", "1e9", "123456"}) EXPECT_FALSE(isOwnNumber(number)) << number;
}

/// This very course, as students get it.
class CourseHandout : public testing::Test {
 protected:
  const Withheld withheld = readWithheld(source);
  Handout handout = readHandout(source);
};

TEST_F(CourseHandout, LeaksNothing) {
  for (const Leak& leak : handout.leaks) ADD_FAILURE() << leak.text();
  // Guards this test against a reader that sees nothing.
  EXPECT_GT(withheld.plain.size(), 100U);
  EXPECT_GT(withheld.sentences.size(), 100U);
  EXPECT_GT(withheld.numbers.size(), 10U);
  EXPECT_GT(withheld.types.size(), 100U);
  EXPECT_GT(handout.tree.size(), 150U);
}

TEST_F(CourseHandout, LeaksTheSolutionWhereItStandsInTheStub) {
  for (const Manifest& exercise : readCourse(source / "exercises")) {
    const std::string& name = exercise.files.front();
    Tree tree;
    tree["exercises/" + exercise.topic + "/" + name] = readFile(source / "solutions" / exercise.topic / name);
    EXPECT_FALSE(findLeaks(tree, withheld, {}).empty()) << exercise.topic;
  }
}

TEST_F(CourseHandout, IsACopyButForThreeFiles) {
  for (const auto& [file, text] : handout.tree) {
    if (file == "README.md" || file == "CMakePresets.json" || file == "framework/course/handed_out.txt") continue;
    EXPECT_EQ(text, readFile(source / file)) << file;
  }
  EXPECT_EQ(handout.tree.at("framework/course/handed_out.txt"), readFile(source / "framework/course/handed_out.txt"));
  EXPECT_EQ(handout.tree.at("CMakePresets.json").find("engine"), std::string::npos);
}

}  // namespace
}  // namespace muelle::grader

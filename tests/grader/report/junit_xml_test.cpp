#include "base/text/words.h"
#include "grader/report/report.h"
#include "sample.h"
#include "well_formed.h"

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace muelle::grader {
namespace {

TEST(JunitXml, CountsEveryCriterion) {
  const std::string xml = junitXml(sampleSubmission());
  EXPECT_EQ(xmlFault(xml), "");
  EXPECT_TRUE(contains(xml, "tests=\"10\" failures=\"8\" errors=\"0\""));
  EXPECT_TRUE(contains(
      xml, "<testsuite name=\"spring_1d\" tests=\"2\" failures=\"0\" errors=\"0\" skipped=\"0\" time=\"0.500\""));
  EXPECT_TRUE(contains(xml, "<testcase classname=\"spring_1d\" name=\"HookeForce\" time=\"0.250\" />"));
}

TEST(JunitXml, AMissingFileIsAFailureAndAMissingRecordAnError) {
  GradedSubmission graded;
  graded.exercises = {exerciseWithoutVerdicts()};
  std::string xml = junitXml(graded);
  EXPECT_TRUE(contains(xml, "failures=\"0\" errors=\"2\" skipped=\"0\""));
  EXPECT_TRUE(contains(xml,
                       "<error message=\"no record of this criterion: the grader failed, not you; run the same command "
                       "again\" type=\"grader's fault\">"));
  graded.exercises[0].build = {BuildOutcome::Status::Missing, "", ""};
  xml = junitXml(graded);
  EXPECT_TRUE(contains(xml, "failures=\"2\" errors=\"0\" skipped=\"0\""));
  EXPECT_TRUE(contains(xml, "<failure message=\"spring_1d.cpp was not handed in\" type=\"not run\">"));
}

TEST(JunitXml, ShowsHowTheFileWasTaken) {
  GradedSubmission graded = sampleSubmission();
  EXPECT_FALSE(contains(junitXml(graded), "<properties>"));
  graded.exercises[0].note = "taken from \"spring_1d (1).cpp\"";
  EXPECT_TRUE(
      contains(junitXml(graded), "<property name=\"note\" value=\"taken from &quot;spring_1d (1).cpp&quot;\" />"));
}

TEST(JunitXml, APartialCriterionIsAFailure) {
  GradedSubmission graded;
  graded.exercises = {
      with(with(exerciseWithoutVerdicts(), verdict("HookeForce", 1, 0)), verdict("Acceleration", 2, 1))};
  EXPECT_TRUE(contains(junitXml(graded), "failures=\"1\" errors=\"0\""));
}

TEST(JunitXml, AFaultOfTheGraderIsAnError) {
  Verdict v = verdict("HookeForce", 5, 0);
  v.graderFault = "disk full";
  GradedSubmission graded;
  graded.exercises = {with(with(exerciseWithoutVerdicts(), v), verdict("Acceleration", 3, 0))};
  const std::string xml = junitXml(graded);
  EXPECT_TRUE(contains(xml, "failures=\"0\" errors=\"1\""));
  EXPECT_TRUE(contains(xml, "<error message=\"the grader failed, not you"));
}

TEST(JunitXml, KeepsAtMostEightKibibytesOfAText) {
  const std::string xml = junitXml(hostileSubmission(std::string(1'000'000, 'x')));
  EXPECT_FALSE(contains(xml, std::string(8193, 'x')));
  EXPECT_LT(xml.size(), 100'000U);
}

TEST(JunitXml, IsWellFormedWithAnyTextInside) {
  for (const std::string& text : hostileTexts()) {
    EXPECT_EQ(xmlFault(junitXml(hostileSubmission(text))), "") << text.substr(0, 40);
  }
}

TEST(JunitXml, IsWellFormedToAnotherParser) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "xmllint is not installed";
  const auto file = std::filesystem::path(::testing::TempDir()) / "muelle_junit_xml_test.xml";
  for (const std::string& text : hostileTexts()) {
    std::ofstream(file, std::ios::binary) << junitXml(hostileSubmission(text));
    EXPECT_EQ(std::system(("xmllint --noout --nonet '" + file.string() + "'").c_str()), 0) << text.substr(0, 40);
  }
  std::filesystem::remove(file);
}

TEST(XmlFault, SeesWhatIsNotWellFormed) {
  const std::string start = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  EXPECT_EQ(xmlFault(start + "<a b=\"c\"><d/>&lt;</a>\n"), "");
  for (const char* bad : {"<a>", "<a></b>", "<a>&x;</a>", "<a>& </a>", "<a b=c/>", "<a b=\"<\"/>", "<a/><a/>",
                          "<a>\x1b</a>", "<a>\xff</a>", "<a b=\"\" b=\"\"/>", "x", ""})
    EXPECT_NE(xmlFault(start + bad), "") << bad;
}

}  // namespace
}  // namespace muelle::grader

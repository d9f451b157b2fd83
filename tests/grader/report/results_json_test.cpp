#include "grader/report/report.h"
#include "sample.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace muelle::grader {
namespace {

using Json = nlohmann::json;

TEST(ResultsJson, HasGradescopesFields) {
  const Json json = Json::parse(resultsJson(sampleSubmission()));
  EXPECT_EQ(json["score"], 9.0);
  EXPECT_EQ(json["execution_time"], 12.3);
  EXPECT_EQ(json["visibility"], "visible");
  ASSERT_EQ(json["tests"].size(), 10u);
  const Json& test = json["tests"][2];
  EXPECT_EQ(test["name"], "A spring in three dimensions: Hooke's force on both nodes");
  EXPECT_EQ(test["number"], "2.1");
  EXPECT_EQ(test["score"], 0.0);
  EXPECT_EQ(test["max_score"], 4.0);
  EXPECT_EQ(test["status"], "failed");
  EXPECT_EQ(test["output_format"], "text");
  EXPECT_EQ(test["visibility"], "visible");
  EXPECT_TRUE(test["output"].get<std::string>().starts_with("Your force has the right size and the wrong sign"));
  EXPECT_EQ(json["tests"][0]["status"], "passed");
  EXPECT_EQ(json["tests"][0]["score"], 4.0);
}

TEST(ResultsJson, TheTestsAddUpToTheScore) {
  const Json json = Json::parse(resultsJson(sampleSubmission()));
  double sum = 0.0;
  for (const Json& test : json["tests"]) sum += test["score"].get<double>();
  EXPECT_EQ(sum, json["score"]);
}

TEST(ResultsJson, AFaultOfTheGraderIsNoScore) {
  Verdict v = verdict("HookeForce", 5, 0);
  v.graderFault = "disk full";
  GradedSubmission graded;
  graded.exercises = {with(with(exerciseWithoutVerdicts(), v), verdict("Acceleration", 3, 0))};
  const Json json = Json::parse(resultsJson(graded));
  EXPECT_FALSE(json.contains("score"));
  EXPECT_FALSE(json["tests"][0].contains("score"));
  EXPECT_NE(json["tests"][0]["output"].get<std::string>().find("disk full"), std::string::npos);
  EXPECT_EQ(json["tests"][1]["score"], 3.0);
  EXPECT_NE(json["output"].get<std::string>().find("not your fault"), std::string::npos);
}

TEST(ResultsJson, AMissingRecordIsNoScore) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[0].verdicts.erase("HookeForce");
  const Json json = Json::parse(resultsJson(graded));
  EXPECT_FALSE(json.contains("score"));
  EXPECT_FALSE(json["tests"][0].contains("score"));
  EXPECT_EQ(json["tests"][0]["output"],
            "no record of this criterion: the grader failed, not you; run the same command again");
  EXPECT_EQ(json["tests"][1]["score"], 3.0);
  EXPECT_TRUE(json["output"].get<std::string>().starts_with("The grader failed"));
}

TEST(ResultsJson, SaysInEveryCriterionHowItsFileWasTaken) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[0].note = "taken from spring_1d (1).cpp";
  const Json json = Json::parse(resultsJson(graded));
  EXPECT_EQ(json["tests"][0]["output"], "note: taken from spring_1d (1).cpp");
  EXPECT_EQ(json["tests"][1]["output"], "note: taken from spring_1d (1).cpp");
}

/// The longest text anywhere in the document.
std::size_t longest(const Json& json) {
  if (json.is_string()) return json.get<std::string>().size();
  std::size_t most = 0;
  if (!json.is_structured()) return 0;
  for (const Json& part : json) most = std::max(most, longest(part));
  return most;
}

TEST(ResultsJson, KeepsAtMostEightKibibytesAField) {
  for (const char* piece : {"x", "é", "two\nlines\n", "\x1b"}) {
    std::string text;
    while (text.size() < 200'000) text += piece;
    EXPECT_LE(longest(Json::parse(resultsJson(hostileSubmission(text)))), 8192U) << piece;
  }
}

TEST(ResultsJson, LongWordsOfOneCompilerLeaveRoomForTheNext) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[3].build = {BuildOutcome::Status::CompileError, "it does not compile", std::string(60'000, 'x')};
  EXPECT_NE(resultsJson(graded).find("'normal' was not declared"), std::string::npos);
}

TEST(ResultsJson, ShowsTheCompilersWords) {
  const Json json = Json::parse(resultsJson(sampleSubmission()));
  EXPECT_NE(json["output"].get<std::string>().find("'normal' was not declared"), std::string::npos);
}

TEST(ResultsJson, ParsesWithAnyTextInside) {
  for (const std::string& text : hostileTexts()) {
    const std::string written = resultsJson(hostileSubmission(text));
    const Json json = Json::parse(written, nullptr, false);
    ASSERT_FALSE(json.is_discarded());
    EXPECT_FALSE(json.contains("score"));
    EXPECT_EQ(json["tests"][0]["status"], "failed");
    for (const char control : std::string("\0\x1b\x7f\r", 4)) EXPECT_EQ(written.find(control), std::string::npos);
  }
}

}  // namespace
}  // namespace muelle::grader

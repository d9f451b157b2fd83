#include "grader/report/report.h"
#include "sample.h"

#include <gtest/gtest.h>
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

#include "base/text/words.h"
#include "grader/class/class_table.h"
#include "grader/report/page.h"
#include "sample_class.h"
#include "well_formed.h"

#include "support/hostile_texts.h"

#include <gtest/gtest.h>
#include <set>

namespace muelle::grader {
namespace {

/// The page without its style sheet, which holds no text of a submission.
std::string body(const GradedClass& graded) {
  const std::string page = classPage(graded);
  return page.substr(page.find("<body>"));
}

TEST(ClassPage, ShowsEachStudentWithPointsAndALinkToTheReport) {
  const std::string page = body(classOfOneExercise({student(1, {4, 0}, {1, 1}), studentWithoutFile(2)}));
  EXPECT_TRUE(contains(page,
                       "<th scope=\"row\"><a href=\"reports/student%2001/report.html\">student 01</a></th><td "
                       "class=\"part\">5.5</td><td class=\"sum\">5.5</td>"))
      << page;
  EXPECT_TRUE(contains(page, "not handed in: 0 points\">–</td><td class=\"sum\">0</td>"));
  EXPECT_FALSE(contains(page, "No score"));
}

TEST(ClassPage, WhatHasNoScoreStandsOnTop) {
  const std::string page =
      body(classOfOneExercise({student(1, {4, 0}, {3, 0}), unreadable(2, "the archive is broken")}));
  const std::size_t why = page.find("<li>student 02: the archive is broken</li>"),
                    histogram = page.find("<svg class=\"hist");
  EXPECT_LT(why, histogram);
  EXPECT_NE(histogram, std::string::npos);
  EXPECT_TRUE(contains(page, "<td class=\"sum none\">no score</td>"));
}

TEST(ClassPage, NamesWhatWasHardestAndCommonest) {
  const std::string page =
      body(classOfOneExercise({withMistake(student(1, {0, 1}, {3, 0}), "wrong_sign"), student(2, {4, 0}, {3, 0})}));
  EXPECT_TRUE(contains(page, "<b>50 %</b> (1 of 2)"));
  EXPECT_TRUE(contains(page, "Your force has the right size and the wrong sign"));
  EXPECT_TRUE(contains(page, "spring_1d, wrong_sign"));
}

TEST(ClassPage, ForbidsScriptsAndOutsideResources) {
  const std::string page = classPage(sampleClass(30));
  EXPECT_TRUE(contains(page,
                       "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
                       "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\">"));
  for (const char* part : {"http://", "https://", "url(", "@import", "<script"})
    EXPECT_FALSE(contains(page, part)) << part;
}

TEST(ClassPage, AClassWithoutAnyScoreHasAPage) {
  EXPECT_TRUE(contains(body(classOfOneExercise({unreadable(1, "broken")})), "median <b>no score</b>"));
}

TEST(RelativeLink, IsAPathAndNothingElse) {
  EXPECT_EQ(relativeLink("reports/a b/report.html"), "reports/a%20b/report.html");
  EXPECT_EQ(relativeLink("javascript:alert(1)"), "javascript%3Aalert%281%29");
  EXPECT_EQ(relativeLink("ñ?#%\"<"), "%C3%B1%3F%23%25%22%3C");
}

TEST(ClassPage, TextOfASubmissionIsOnlyText) {
  const std::set<std::string> elements{"body",  "main",  "header", "footer", "section", "div", "p",    "h1",   "h2",
                                       "span",  "b",     "a",      "ul",     "li",      "svg", "rect", "line", "text",
                                       "title", "table", "thead",  "tbody",  "tr",      "th",  "td"};
  const std::set<std::string> attributes{"class", "href",  "title",      "viewBox", "preserveAspectRatio",
                                         "role",  "scope", "aria-label", "width",   "height",
                                         "x",     "y",     "x1",         "x2",      "y1",
                                         "y2"};
  const std::size_t plain = startTags(body(hostileClass("plain text"))).size();
  for (const std::string& text : hostileTexts()) {
    const std::vector<Tag> tags = startTags(body(hostileClass(text)));
    EXPECT_EQ(tags.size(), plain) << text.substr(0, 40);
    for (const Tag& tag : tags) {
      EXPECT_TRUE(elements.contains(tag.name)) << tag.name;
      for (const std::string& attribute : tag.attributes) EXPECT_TRUE(attributes.contains(attribute)) << attribute;
    }
  }
}

}  // namespace
}  // namespace muelle::grader

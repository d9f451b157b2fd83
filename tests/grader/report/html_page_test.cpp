#include "base/text/words.h"
#include "grader/report/report.h"
#include "sample.h"
#include "well_formed.h"

#include <gtest/gtest.h>
#include <limits>
#include <set>

namespace muelle::grader {
namespace {

/// The page without its style sheet, which holds no text of a submission.
std::string body(const GradedSubmission& graded) {
  const std::string page = htmlPage(graded);
  return page.substr(page.find("<body>"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

TEST(HtmlPage, ShowsEveryCriterionWithItsPoints) {
  const std::string page = body(sampleSubmission());
  EXPECT_EQ(count(page, "<div class=\"criterion "), 10u);
  EXPECT_TRUE(contains(page, "<b>9</b> of 35"));
  EXPECT_TRUE(contains(page, "García Núñez, Inés.zip"));
  EXPECT_TRUE(contains(page, "&#39;normal&#39; was not declared in this scope"));
  EXPECT_TRUE(contains(page, "damping.cpp was not handed in"));
}

TEST(HtmlPage, PutsTheMistakeBeforeThePropertyBeforeTheValues) {
  const std::string page = body(sampleSubmission());
  const std::size_t mistake = page.find("right size and the wrong sign"), property = page.find("obeys law number 0"),
                    call = page.find("springForce(0.5"), got = page.find("<dd class=\"got\">-2.5</dd>");
  EXPECT_LT(mistake, property);
  EXPECT_LT(property, call);
  EXPECT_LT(call, got);
  EXPECT_NE(got, std::string::npos);
}

TEST(HtmlPage, SaysWhatToMendAboveTheFirstExercise) {
  const std::string page = body(sampleSubmission());
  const std::string overview = page.substr(0, page.find("<section class=\"exercise"));
  for (const char* line :
       {"right size and the wrong sign", "damping.cpp was not handed in", "contact.cpp does not compile: 1 error"})
    EXPECT_TRUE(contains(overview, line)) << line;
  GradedSubmission unexplained = sampleSubmission();
  unexplained.exercises[1].verdicts.at("HookeForce").mistakes.clear();
  EXPECT_TRUE(contains(body(unexplained), "<li>not right yet: Hooke&#39;s force on both nodes"));
}

TEST(HtmlPage, FoldsWhatIsExplainedAboveAndShowsWhatIsNot) {
  GradedSubmission graded = sampleSubmission();
  const std::string fold = "explained above; the numbers</summary>\n<p class=\"cause\">Your force has the right size";
  EXPECT_TRUE(contains(body(graded), fold));
  graded.exercises[1].verdicts.at("HookeForce").mistakes.clear();
  const std::string page = body(graded);
  EXPECT_FALSE(contains(page, fold));
  EXPECT_TRUE(contains(page, "obeys law number 0"));
}

TEST(HtmlPage, ShowsGotAndExpectedFromTheNumbersWhateverTheNamesSay) {
  GradedSubmission graded = sampleSubmission();
  Mismatch& m = graded.exercises[1].verdicts.at("HookeForce").tests[1].mismatches[0];
  m.label = "f: got 7, expected 8 (x";
  m.unit = "N";
  std::string page = body(graded);
  EXPECT_TRUE(contains(page,
                       "<p class=\"what\">f: got 7, expected 8 (x</p>\n<dl><dt>got</dt><dd class=\"got\">-2.5 N</dd>"
                       "<dt>expected</dt><dd><span class=\"wanted\">2.5 N</span><span class=\"rest\"> (difference -5, "
                       "tolerance 1e-12)</span></dd></dl>"));
  m.label = "";
  m.got = std::numeric_limits<double>::quiet_NaN();
  page = body(graded);
  EXPECT_TRUE(contains(page, "<dd class=\"got\">NaN, which is not a finite number</dd>"));
  m.gotRows = 3;
  page = body(graded);
  EXPECT_TRUE(contains(page, "<dd class=\"got\">3 components</dd>"));
}

TEST(HtmlPage, SaysWhatWasNeverWrittenBeforeTheMistake) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[1].verdicts.at("HookeForce").outcome = Outcome::NeverWritten;
  const std::string page = body(graded);
  EXPECT_LT(page.find("returned memory to which nothing was written"), page.find("right size and the wrong sign"));
}

TEST(HtmlPage, ShowsHowTheFileWasTaken) {
  GradedSubmission graded = sampleSubmission();
  graded.exercises[0].note = "taken from <b>.cpp";
  EXPECT_TRUE(contains(body(graded), "taken from &lt;b&gt;.cpp"));
}

TEST(HtmlPage, HasTheCurvesAsImages) {
  const std::string page = body(sampleSubmission());
  EXPECT_EQ(count(page, " src=\"data:image/svg+xml;base64,"), 3u);
  EXPECT_EQ(count(page, " src="), 3u);
  EXPECT_TRUE(contains(page, "No curves: the demo stopped"));
}

TEST(HtmlPage, ForbidsScriptsAndOutsideResources) {
  const std::string page = htmlPage(sampleSubmission());
  EXPECT_TRUE(
      contains(page,
               "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
               "img-src data:; base-uri 'none'; form-action 'none'\">"));
  EXPECT_FALSE(contains(page, "http://"));
  EXPECT_FALSE(contains(page, "https://"));
  EXPECT_FALSE(contains(page, "url("));
}

TEST(HtmlPage, SaysWhenTheGraderFailed) {
  GradedSubmission graded = sampleSubmission();
  EXPECT_FALSE(contains(body(graded), "class=\"warning\""));
  graded.exercises[0].verdicts.at("HookeForce").graderFault = "disk full";
  const std::string page = body(graded);
  EXPECT_TRUE(contains(page, "class=\"warning\""));
  EXPECT_TRUE(contains(page, "<b>no score</b> / 4"));
  EXPECT_TRUE(contains(page, "<b>no score</b> of 35"));
  EXPECT_TRUE(contains(htmlPage(graded), "<title>no score / 35"));
}

TEST(HtmlPage, TextOfASubmissionIsOnlyText) {
  const std::set<std::string> elements{"body", "main", "header", "footer", "section", "nav",     "div",    "p",   "h1",
                                       "h2",   "h3",   "span",   "b",      "a",       "ul",      "li",     "pre", "dl",
                                       "dt",   "dd",   "svg",    "rect",   "img",     "details", "summary"};
  const std::set<std::string> attributes{"class", "id",         "href",    "title",
                                         "src",   "alt",        "viewBox", "preserveAspectRatio",
                                         "role",  "aria-label", "width",   "height"};
  const std::size_t plain = startTags(body(hostileSubmission("plain text"))).size();
  for (const std::string& text : hostileTexts()) {
    const std::vector<Tag> tags = startTags(body(hostileSubmission(text)));
    // Fewer when a long line was cut; one more would be of the text.
    EXPECT_LE(tags.size(), plain) << text.substr(0, 40);
    for (const Tag& tag : tags) {
      EXPECT_TRUE(elements.contains(tag.name)) << tag.name;
      for (const std::string& attribute : tag.attributes) EXPECT_TRUE(attributes.contains(attribute)) << attribute;
    }
  }
}

}  // namespace
}  // namespace muelle::grader

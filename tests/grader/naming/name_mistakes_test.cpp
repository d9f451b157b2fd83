#include "grader/naming/name_mistakes.h"

#include "grader/naming/merged_evidence.h"
#include "grader/testing/gather_evidence.h"
#include "spring_history.h"

#include <gtest/gtest.h>
#include <limits>

namespace muelle::grader {
namespace {

/// One criterion, lost, whose calls of force() are those of the history.
Verdict lostBy(const ForceHistory& history, const std::string& suite = "Force") {
  Verdict verdict;
  verdict.suite = suite;
  verdict.tests = {{"Fails", "", false, {}, ""}};
  verdict.evidence["force"] = gatherEvidence(history);
  return verdict;
}

GradedExercise exerciseOf(std::vector<Verdict> verdicts) {
  GradedExercise exercise;
  exercise.build.status = BuildOutcome::Status::Built;
  exercise.manifest.topic = "spring";
  for (Verdict& verdict : verdicts) {
    exercise.manifest.criteria.push_back({verdict.suite, verdict.suite, 1.0, false, "", {"force"}, {}});
    exercise.verdicts[verdict.suite] = std::move(verdict);
  }
  return exercise;
}

/// What is said first of a submission with this force.
NamedMistake named(const ForceFunction& own, const std::string& source = "") {
  ForceHistory history;
  ask(history, own, 40);
  GradedExercise exercise = exerciseOf({lostBy(history)});
  nameMistakes(exercise, springContract, source);
  const std::vector<NamedMistake>& mistakes = exercise.verdicts.at("Force").mistakes;
  return mistakes.empty() ? NamedMistake{"none", "", "", ""} : mistakes.front();
}

TEST(Naming, FindsWhatAnyFunctionMayHoldWithoutAList) {
  EXPECT_EQ(named([](double x, double k, double L0) { return -rightForce(x, k, L0); }).id, "wrong_sign");
  EXPECT_EQ(named([](double x, double k, double L0) { return 2 * rightForce(x, k, L0); }).id, "doubled");
  EXPECT_EQ(named([](double x, double k, double L0) { return std::abs(rightForce(x, k, L0)); }).id, "absolute_value");
  EXPECT_EQ(named([](double x, double k, double L0) { return std::min(0.0, rightForce(x, k, L0)); }).id, "rope");
  EXPECT_EQ(named([](double x, double k, double) { return -k * x; }).says,
            "force leaves L0 out: it answers as if that were 0");
  EXPECT_EQ(named([](double x, double, double L0) { return -(x - L0); }).says,
            "force leaves k out: it answers as if that were 1");
  EXPECT_EQ(named([](double x, double k, double L0) { return -k * (x * x - L0); }).says,
            "force takes the square of x where x itself belongs");
  EXPECT_EQ(named([](double x, double k, double L0) { return -(x - L0) / k; }).says,
            "force divides by k where it should multiply");
  EXPECT_EQ(named([](double x, double k, double L0) { return rightForce(k, x, L0); }).says,
            "force answers as if x and k were exchanged");
  EXPECT_EQ(named([](double x, double k, double L0) { return rightForce(std::trunc(x), k, L0); }).id, "whole_numbers");
  EXPECT_EQ(named([](double, double, double) { return 0.0; }).id, "zero");
  EXPECT_EQ(named([](double, double, double) { return 3.0; }).id, "constant");
}

TEST(Naming, SaysWhereRightAndWrongPart) {
  const NamedMistake oneSided =
      named([](double x, double k, double L0) { return x - L0 > 0 ? rightForce(x, k, L0) : 7.0; });
  EXPECT_EQ(oneSided.says, "force is wrong where x - L0 is negative, and is right elsewhere");
  const NamedMistake noNumber = named([](double x, double k, double L0) {
    return x < 1.5 ? std::numeric_limits<double>::quiet_NaN() : rightForce(x, k, L0);
  });
  EXPECT_EQ(noNumber.id, "missing_guard");
  EXPECT_EQ(noNumber.says, "force gives no finite number in 4 of 40 calls, and is right elsewhere");
}

/// Where a number is 0 the mistake may not show: that takes nothing from what all other calls say.
TEST(Naming, AnAnswerThatIsRightAtZeroHidesNoBorder) {
  ForceHistory history;
  const auto own = [](double x, double k, double L0) { return x - L0 > 0 ? rightForce(x, k, L0) : 7.0 * k; };
  ask(history, own, 40);
  for (const double x : {0.3, 0.7, 1.9}) {
    history.add(withoutTypes(std::tuple<double, double, double>(x, 0.0, 1.0)), {own(x, 0.0, 1.0)});
  }
  GradedExercise exercise = exerciseOf({lostBy(history)});
  nameMistakes(exercise, springContract, "");
  ASSERT_FALSE(exercise.verdicts.at("Force").mistakes.empty());
  EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().id, "one_sided");
}

TEST(Naming, OfWhatIsNearlyRightTellsTheDigits) {
  const auto single = [](double x, double k, double L0) {
    return static_cast<double>(static_cast<float>(rightForce(x, k, L0)));
  };
  const NamedMistake found = named(single, "double force() {\n  float F = 0;\n}\n");
  EXPECT_EQ(found.id, "single_precision");
  EXPECT_NE(found.says.find("line 2 computes with float"), std::string::npos) << found.says;
  EXPECT_EQ(named(single).id, "difference_quotient");
}

TEST(Naming, NamesNothingThatExplainsNotAllCalls) {
  const auto odd = [](double x, double k, double L0) { return rightForce(x, k, L0) * (1 + std::sin(50 * x)); };
  EXPECT_EQ(named(odd).id, "none");
  EXPECT_EQ(named(rightForce).id, "none");
}

TEST(Naming, LooksAtAllCriteria) {
  // Twice the right force in one criterion, three times in the other: neither is named.
  ForceHistory doubled, tripled;
  ask(doubled, [](double x, double k, double L0) { return 2 * rightForce(x, k, L0); });
  ask(tripled, [](double x, double k, double L0) { return 3 * rightForce(x, k, L0); });
  GradedExercise alone = exerciseOf({lostBy(doubled)});
  nameMistakes(alone, springContract, "");
  EXPECT_EQ(alone.verdicts.at("Force").mistakes.size(), 1U);
  GradedExercise both = exerciseOf({lostBy(doubled), lostBy(tripled, "Other")});
  nameMistakes(both, springContract, "");
  EXPECT_TRUE(both.verdicts.at("Force").mistakes.empty());
}

TEST(Naming, AsksNothingOfARunWithTheReferencesFunction) {
  ForceHistory doubled, right;
  ask(doubled, [](double x, double k, double L0) { return 2 * rightForce(x, k, L0); });
  ask(right, rightForce);
  Verdict followed = lostBy(right, "Later");
  followed.tests.front().passed = true;
  followed.outcome = Outcome::Passed;
  followed.followed = {"force"};
  GradedExercise exercise = exerciseOf({lostBy(doubled), followed});
  nameMistakes(exercise, springContract, "");
  ASSERT_EQ(exercise.verdicts.at("Force").mistakes.size(), 1U);
  EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().id, "doubled");
}

TEST(Naming, PrefersTheManifestsWordsAndSaysBothWhereTwoFit) {
  ForceHistory history;
  history.addMistake("twice", [](double x, double k, double L0) { return 2 * rightForce(x, k, L0); });
  history.addMistake("both_ends", [](double x, double k, double L0) { return 2 * rightForce(x, k, L0); });
  ask(history, [](double x, double k, double L0) { return 2 * rightForce(x, k, L0); });
  GradedExercise exercise = exerciseOf({lostBy(history)});
  exercise.manifest.misconceptions = {{"twice", "force", "the half is missing", "h"}};
  nameMistakes(exercise, springContract, "");
  EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().says, "the half is missing");

  exercise = exerciseOf({lostBy(history)});
  exercise.manifest.misconceptions = {{"twice", "force", "the half is missing", "h"},
                                      {"both_ends", "force", "each spring counts twice", "h"}};
  nameMistakes(exercise, springContract, "");
  EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().says,
            "the half is missing; or, with the same numbers, each spring counts twice");
}

TEST(Naming, PrefersTheManifestsWordsForWhatIsAlwaysTheSame) {
  for (const double answer : {0.0, 3.0}) {
    const auto same = [answer](double, double, double) { return answer; };
    ForceHistory history;
    history.addMistake("rigid", same);
    ask(history, same, 40);
    GradedExercise exercise = exerciseOf({lostBy(history)});
    exercise.manifest.misconceptions = {{"rigid", "force", "the spring never moves", "h"}};
    nameMistakes(exercise, springContract, "");
    EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().says, "the spring never moves") << answer;
  }
}

TEST(Naming, SaysWhatALostTestHasSeenAtWork) {
  Verdict lost, earned;
  lost.suite = "Fast";
  earned.suite = "Exact";
  lost.tests = {{"Fails", "", false, {}, "", {"force", "asked_too_often"}}};
  earned.tests = {{"Holds", "", true, {}, "", {"force", "asked_too_often"}}};
  earned.outcome = Outcome::Passed;
  GradedExercise exercise = exerciseOf({lost, earned});
  exercise.manifest.misconceptions = {{"asked_too_often", "other", "of another function", ""},
                                      {"asked_too_often", "force", "you ask too often", "take longer steps"}};
  nameMistakes(exercise, springContract, "");
  const NamedMistake expected{"asked_too_often", "force", "you ask too often", "take longer steps"};
  EXPECT_EQ(exercise.verdicts.at("Fast").mistakes, std::vector<NamedMistake>{expected});
  EXPECT_TRUE(exercise.verdicts.at("Exact").mistakes.empty());
}

/// What is built on a function that always gives 0 leaves out what that one would have looked at: no mistake of its
/// own.
TEST(Naming, SaysNothingOfWhatIsBuiltOnAnAnswerThatIsAlwaysTheSame) {
  const auto firstOf = [](const ForceFunction& lower) {
    ForceHistory force, built;
    ask(force, lower, 40);
    ask(
        built, [](double x, double k, double) { return -k * x; }, 40);
    Verdict verdict = lostBy(built, "Built");
    verdict.evidence["builtOnForce"] = verdict.evidence.extract("force").mapped();
    GradedExercise exercise = exerciseOf({lostBy(force), verdict});
    exercise.manifest.criteria.back().functions = {"builtOnForce"};
    exercise.manifest.criteria.back().follows = {"force"};
    nameMistakes(exercise, springContract, "");
    const std::vector<NamedMistake>& mistakes = exercise.verdicts.at("Built").mistakes;
    return mistakes.empty() ? std::string("none") : mistakes.front().id;
  };
  EXPECT_EQ(firstOf(rightForce), "ignored");
  EXPECT_EQ(firstOf([](double, double, double) { return 0.0; }), "none");
  EXPECT_EQ(firstOf([](double, double, double) { return 3.0; }), "none");
}

TEST(Naming, BlamesNoLowerFunctionThatIsRight) {
  ForceHistory history;
  history.addMistake("sign", [](double x, double k, double L0) { return -rightForce(x, k, L0); });
  ask(history, [](double x, double k, double L0) { return -rightForce(x, k, L0); });
  GradedExercise exercise = exerciseOf({lostBy(history)});
  exercise.manifest.misconceptions = {{"sign", "length", "your length has the wrong sign", "h"}};
  nameMistakes(exercise, springContract, "");
  EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().function, "force");
  EXPECT_EQ(exercise.verdicts.at("Force").mistakes.front().says, "in force, your length has the wrong sign");
}

}  // namespace
}  // namespace muelle::grader

#include "catch_the_mistake.h"

#include "course/testing/expect.h"
#include "course/testing/question_log.h"
#include "course/testing/random.h"
#include "grader/testing/implementation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>

using muelle::QuestionLog;
using muelle::Random;
using muelle::testRandom;
using muelle::grader::Implementation;
using muelle::grader::implementationsOf;

namespace {

constexpr long mostQuestions = 500;  // of the contract

// --- what is judged -------------------------------------------------------------------------------------------------

/// Something to be judged, and how the student's function and the oracle are asked.
struct Candidate {
  bool isRight;
  std::function<bool(const QuestionLog&)> student;
  std::function<bool()> oracle;
};

/// What stands in the place of an implementation where a call is shown.
std::string shown(const Implementation& implementation) {
  return implementation.isRight() ? "/* a right one */" : fmt::format("/* one that {} */", implementation.says());
}

Candidate force(const Implementation& implementation) {
  const auto f = implementation.function<double(double, double, double, double)>("springForceOnA");
  const auto ask = [f, source = shown(implementation)](const QuestionLog& log) {
    return submission::isSpringForceRight(log.kept("springForceOnA", source, f));
  };
  return {implementation.isRight(), ask, [f] { return oracle::isSpringForceRight(f); }};
}

/// An energy of one submission with a gradient of the same, or of another.
Candidate gradient(const Implementation& ofEnergy, const Implementation& ofGradient) {
  const auto energy = ofEnergy.function<double(const Vec6&, double, double)>("springEnergy");
  const auto slope = ofGradient.function<Vec6(const Vec6&, double, double)>("energyGradient");
  const auto ask = [energy, slope, source = shown(ofEnergy)](const QuestionLog& log) {
    return submission::isGradientRight(log.kept("springEnergy", source, energy),
                                       log.kept("energyGradient", "/* its gradient */", slope));
  };
  return {ofEnergy.isRight(), ask, [energy, slope] { return oracle::isGradientRight(energy, slope); }};
}

Candidate gradient(const Implementation& implementation) { return gradient(implementation, implementation); }

Candidate damping(const Implementation& implementation) {
  const auto f =
      implementation.function<Vec3(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double)>("projectedDamping");
  const auto ask = [f, source = shown(implementation)](const QuestionLog& log) {
    return submission::isDampingRight(log.kept("projectedDamping", source, f));
  };
  return {implementation.isRight(), ask, [f] { return oracle::isDampingRight(f); }};
}

using Judged = Candidate (*)(const Implementation&);

/// Those of the groups, in the order of the list.
std::vector<Implementation> listed(const std::string& exercise, const std::vector<std::string>& groups) {
  std::vector<Implementation> found;
  for (const Implementation& each : implementationsOf(exercise)) {
    if (std::find(groups.begin(), groups.end(), each.group()) != groups.end()) found.push_back(each);
  }
  if (found.empty()) throw std::runtime_error("nothing of " + exercise + " is listed");
  return found;
}

std::vector<Candidate> candidates(const std::string& exercise, Judged judged, const std::vector<std::string>& groups) {
  std::vector<Candidate> found;
  for (const Implementation& each : listed(exercise, groups)) found.push_back(judged(each));
  return found;
}

// --- the verdicts ---------------------------------------------------------------------------------------------------

struct Judgement {
  bool isTakenForRight;
  bool isRight;
  QuestionLog log;
};

/// For EXPECT_PRED_FORMAT1: in the student's words, with the questions.
::testing::AssertionResult isTrue(const char*, const Judgement& judgement) {
  const auto refused = [](const std::string& words) { return ::testing::AssertionFailure() << words; };
  const std::string questions = judgement.log.count() == 0 ? "you asked nothing" : "you asked: " + judgement.log.text();
  if (judgement.log.count() > mostQuestions)
    return refused(
        fmt::format("your function asked {} questions; it may ask {}", judgement.log.count(), mostQuestions));
  if (judgement.isTakenForRight == judgement.isRight) return ::testing::AssertionSuccess();
  return refused(
      fmt::format("your function takes this for {}; {}", judgement.isTakenForRight ? "right" : "wrong", questions));
}

/// In an order that nobody knows: what an implementation is does not follow from those before.
void expectTrueVerdicts(std::vector<Candidate> all) {
  Random random = testRandom();
  for (std::size_t i = all.size() - 1; i > 0; --i) {
    std::swap(all[i], all[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  for (const Candidate& candidate : all) {
    if (candidate.oracle() != candidate.isRight) throw std::logic_error("the oracle errs about an implementation");
    const QuestionLog log;
    const bool verdict = candidate.student(log);
    EXPECT_PRED_FORMAT1(isTrue, (Judgement{verdict, candidate.isRight, log}));
  }
}

}  // namespace

// --- springForceOnA -------------------------------------------------------------------------------------------------

TEST(ForceValues, AreLookedAt) {
  MUELLE_PROPERTY("a right force is taken for right, and one that is wrong at nearly any question for wrong");
  expectTrueVerdicts(candidates("spring_1d", force, {"plain", "values"}));
}

TEST(ForceSides, AreLookedAt) {
  MUELLE_PROPERTY(
      "a right force is taken for right; one that is wrong for one order of the nodes, for compressed springs, or for "
      "some stiffness or rest length only, for wrong");
  expectTrueVerdicts(candidates("spring_1d", force, {"plain", "sides"}));
}

TEST(ForceEdges, AreLookedAt) {
  MUELLE_PROPERTY("a right force is taken for right, and one that is wrong where nodes (nearly) coincide for wrong");
  expectTrueVerdicts(candidates("spring_1d", force, {"plain", "edges"}));
}

// --- springEnergy and energyGradient --------------------------------------------------------------------------------

TEST(GradientValues, AreLookedAt) {
  MUELLE_PROPERTY("a right energy with its gradient is taken for right, and one with a wrong gradient for wrong");
  expectTrueVerdicts(candidates("energy_gradient", gradient, {"plain", "values"}));
}

TEST(EnergyValues, AreLookedAt) {
  MUELLE_PROPERTY("a right energy with its gradient is taken for right, and a wrong energy for wrong");
  expectTrueVerdicts(candidates("energy_gradient", gradient, {"plain", "energy"}));
}

TEST(WrongTogether, IsSeen) {
  MUELLE_PROPERTY(
      "a right energy with its gradient is taken for right; where both are wrong, for wrong, although the one is the "
      "derivative of the other");
  std::vector<Candidate> all = candidates("energy_gradient", gradient, {"plain"});
  const std::vector<Implementation> pairs = listed("energy_gradient", {"pairs"});
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) all.push_back(gradient(pairs[i], pairs[i + 1]));
  expectTrueVerdicts(all);
}

TEST(GradientEdges, AreLookedAt) {
  MUELLE_PROPERTY(
      "a right energy with its gradient is taken for right; one that is wrong for compressed springs, without rest "
      "length or where nodes (nearly) coincide only, for wrong");
  expectTrueVerdicts(candidates("energy_gradient", gradient, {"plain", "edges"}));
}

// --- projectedDamping -----------------------------------------------------------------------------------------------

TEST(DampingValues, AreLookedAt) {
  MUELLE_PROPERTY("a right damping is taken for right, and one that is wrong at nearly any question for wrong");
  expectTrueVerdicts(candidates("damping", damping, {"plain", "values"}));
}

TEST(DampingDirections, AreLookedAt) {
  MUELLE_PROPERTY(
      "a right damping is taken for right; one that is right for some positions or velocities only, for wrong");
  expectTrueVerdicts(candidates("damping", damping, {"plain", "directions"}));
}

TEST(DampingEdges, AreLookedAt) {
  MUELLE_PROPERTY(
      "a right damping is taken for right; one that is wrong where nodes (nearly) coincide, or far apart, for wrong");
  expectTrueVerdicts(candidates("damping", damping, {"plain", "edges"}));
}

// --- EveryRightOne: partial, one test a function
// ----------------------------------------------------------------------

namespace {

/// Every right one, and one that nobody can miss who asks anything.
void expectAllRightOnes(const std::string& exercise, Judged judged, const Candidate& wrong) {
  std::vector<Candidate> all = candidates(exercise, judged, {"plain", "other"});
  all.push_back(wrong);
  expectTrueVerdicts(all);
}

Implementation named(const std::string& exercise, const std::string& submission) {
  for (const Implementation& each : implementationsOf(exercise)) {
    if (each.submission() == submission) return each;
  }
  throw std::runtime_error(submission + " is not listed");
}

}  // namespace

TEST(EveryRightOne, OfTheForces) {
  MUELLE_PROPERTY("a right force is taken for right, however it is written and rounds; half of it is not");
  expectAllRightOnes("spring_1d", force, force(named("spring_1d", "wrong/force_halved")));
}

TEST(EveryRightOne, OfTheGradients) {
  MUELLE_PROPERTY(
      "right energies and gradients are taken for right, however they are written and round; wrong are not");
  // Wrong is the energy, the gradient, and that the one is the derivative of the other.
  expectAllRightOnes(
      "energy_gradient", gradient,
      gradient(named("energy_gradient", "wrong/missing_half"), named("energy_gradient", "wrong/gradient_keeps_half")));
}

TEST(EveryRightOne, OfTheDampings) {
  MUELLE_PROPERTY("a right damping is taken for right, however it is written and rounds; half of it is not");
  expectAllRightOnes("damping", damping, damping(named("damping", "wrong/projected_half_to_each_end")));
}

// --- ItThrew: partial, one test a function
// ----------------------------------------------------------------------------

namespace {

double forceThatThrows(double, double, double, double) { throw std::domain_error("no force"); }

double energyAsItIs(const Vec6& x, double k, double L0) {
  return listed("energy_gradient", {"plain"})
      .front()
      .function<double(const Vec6&, double, double)>("springEnergy")(x, k, L0);
}

Vec6 gradientThatThrows(const Vec6&, double, double) { throw std::domain_error("no gradient"); }

Vec3 dampingThatThrows(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) {
  throw std::domain_error("no damping");
}

void expectRefused(const std::string& exercise, Judged judged, const std::string& says,
                   const Implementation::Functions& functions) {
  std::vector<Candidate> all = candidates(exercise, judged, {"plain"});
  all.push_back(judged(Implementation("wrong/throws", "throws", says, functions)));
  expectTrueVerdicts(all);
}

}  // namespace

TEST(ItThrew, ForAForce) {
  MUELLE_PROPERTY("a force that throws an exception is taken for wrong, and a right one for right");
  expectRefused("spring_1d", force, "throws an exception", {{"springForceOnA", &forceThatThrows}});
}

TEST(ItThrew, ForAGradient) {
  MUELLE_PROPERTY("a gradient that throws an exception is taken for wrong, and a right one for right");
  expectRefused("energy_gradient", gradient, "has a gradient that throws an exception",
                {{"springEnergy", &energyAsItIs}, {"energyGradient", &gradientThatThrows}});
}

TEST(ItThrew, ForADamping) {
  MUELLE_PROPERTY("a damping that throws an exception is taken for wrong, and a right one for right");
  expectRefused("damping", damping, "throws an exception", {{"projectedDamping", &dampingThatThrows}});
}

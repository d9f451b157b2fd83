/// \file
/// The matrix of the hard cases: its predictions are theory, its verdicts cannot be talked into passing.

#include "base/file.h"
#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/million_periods.h"
#include "lab/hard_cases/models.h"
#include "lab/hard_cases/references.h"
#include "lab/hard_cases/report.h"
#include "lab/hard_cases/sensitivity.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <set>

namespace muelle::hard_cases {
namespace {

using engine::methodInfo;

double endOf(const char* id, double omega, double h, long long steps) {
  const Mode m{.stiffness = omega * omega};
  const double T = h * static_cast<double>(steps);
  return forecast(methodInfo(id), m, h, T)->size;
}

TEST(LinearTheory, FollowsTheClosedForms) {
  const double y = 0.1;
  EXPECT_NEAR(endOf("explicit_euler", 1.0, y, 100), std::pow(1.0 + y * y, 50.0), 1e-12);
  EXPECT_NEAR(endOf("backward_euler", 1.0, y, 100), std::pow(1.0 + y * y, -50.0), 1e-12);
  EXPECT_NEAR(endOf("implicit_midpoint", 1.0, y, 100), 1.0, 1e-13);
  const Mode unit{};
  EXPECT_NEAR(forecast(methodInfo("velocity_verlet"), unit, y, 100.0)->error,
              std::abs(2.0 * std::sin(500.0 * (std::acos(1.0 - y * y / 2.0) - y))), 3e-3);
  EXPECT_FALSE(forecast(methodInfo("dormand_prince_5"), unit, y, 1.0).has_value());
}

// The limits that the methods state, from the matrices written here: neither is taken from the other.
TEST(LinearTheory, AgreesWithTheLimitsThatMethodsState) {
  for (const char* id : {"symplectic_euler", "velocity_verlet", "runge_kutta_4", "yoshida4", "kahan_li_8"}) {
    const double limit = methodInfo(id).imaginaryLimit;
    const auto growth = [&](double z) { return forecast(methodInfo(id), Mode{}, z, 10 * z)->growth; };
    EXPECT_LE(growth(0.999 * limit), 1.0 + 1e-9) << id;
    EXPECT_GT(growth(1.001 * limit), 1.0 + 1e-4) << id;
  }
}

TEST(LinearTheory, DampingIsExactForEveryMethodInTheLimit) {
  const Mode m{.stiffness = 4.0, .amplitude = 1.0, .speed = 0.5, .damping = 0.3, .drag = 0.2};
  for (const std::string& id : engine::methodIds()) {
    const auto coarse = forecast(methodInfo(id), m, 1e-2, 1.0), fine = forecast(methodInfo(id), m, 5e-3, 1.0);
    if (!coarse) continue;
    EXPECT_LT(fine->error, 0.02) << id;
    if (fine->error > 1e-13) {
      EXPECT_GT(coarse->error / fine->error, 1.7) << id;
    }
  }
}

TEST(HardCaseMatrix, CoversEveryCaseAndEveryMethod) {
  const Matrix matrix = planMatrix({});
  std::set<std::string> cases;
  for (const Variant& variant : matrix.variants) cases.insert(variant.id);
  EXPECT_EQ(cases.size(), allCases().size());
  EXPECT_EQ(matrix.methods, engine::methodIds());
  EXPECT_THROW(planMatrix({.cases = {"H25"}}), std::invalid_argument);
  EXPECT_THROW(planMatrix({.methods = {"velocity_verlett"}}), std::invalid_argument);
}

Variant variantOf(const std::string& id, const std::string& name = "") {
  for (Variant& variant : allVariants()) {
    if (variant.id == id && (name.empty() || variant.name == name)) return variant;
  }
  throw std::out_of_range(id);
}

// The formula is not TR-BDF2's own program, nor is there one that has to be: gamma = 2 - sqrt(2) makes it L-stable, and
// its error of phase on the oscillator is (h omega)^3 (3 sqrt(2) - 4) / 6 a step.
TEST(LinearTheory, KnowsTrBdf2) {
  engine::MethodInfo info;
  info.id = "tr_bdf2";
  const Mode stiff{.stiffness = 1e12};
  EXPECT_LT(forecast(info, stiff, 1.0, 1.0)->size, 1e-4);
  const double h = 1e-2, steps = 100;
  const double phase = forecast(info, Mode{}, h, steps * h)->phase;
  EXPECT_NEAR(std::abs(phase) / (steps * h * h * h * (3.0 * std::sqrt(2.0) - 4.0) / 6.0), 1.0, 1e-3);
}

// Kept from a run on the mode alone, the numbers are those of the formula: two ways to the same forecast.
TEST(LinearTheory, AgreesWithRunsOnTheModeAlone) {
  const Mode m{.stiffness = 9.0, .amplitude = 0.5, .speed = 1.0, .damping = 0.1};
  for (const char* id : {"velocity_verlet", "runge_kutta_4", "kahan_li_8", "bdf2", "implicit_midpoint"}) {
    const auto formula = forecast(methodInfo(id), m, 0.05, 10.0);
    const auto run = measuredForecast(methodInfo(id), m, {.duration = 10.0, .h = 0.05, .budget = 100'000});
    ASSERT_TRUE(formula && run) << id;
    EXPECT_NEAR(run->position, formula->position, 1e-9) << id;
    EXPECT_NEAR(run->size, formula->size, 1e-9) << id;
  }
}

// x(t) = x(0) cos 3t + v(0)/3 sin 3t: the change of the end by 1 m at a time, with velocities in units of 3 m/s, is
// sqrt((cos^2 + sin^2) / 2) over both directions; along the motion it is |v(T)| over the constant speed 3 m/s.
TEST(Sensitivity, IsThatOfTheClosedFormOnAnOscillator) {
  Variant v{.id = "oscillator", .name = ""};
  v.model = oscillator(9.0);
  v.duration = 2.0;
  const double expected = std::cos(6.0);
  v.error = [=](const Finished& end) { return std::abs(end.x(0)[0] - expected); };
  v.modes = {{.stiffness = 9.0}};
  const Sensitivity s = sensitivityOf(v);
  const Sensitivity::Growth growth = s.between(0.0, 2.0);
  EXPECT_NEAR(growth.any, std::sqrt(0.5), 2e-3);
  EXPECT_NEAR(growth.along, std::abs(std::sin(6.0)), 2e-3);
  EXPECT_NEAR(s.endSpeed, 3.0 * std::abs(std::sin(6.0)), 1e-8);
  EXPECT_NEAR(extentOf(v), 1.0 - std::cos(3.0), 0.02) << "from 1 m to -1 m, and the anchor between";
}

// What the collection states of growths, from measurements of another program: 1.2 (regular), 1e4 in 20 s (chaotic).
TEST(Sensitivity, OfThePendulumsIsWhatTheCollectionStates) {
  const Sensitivity regular = sensitivityOf(variantOf("H04", "regular")),
                    chaotic = sensitivityOf(variantOf("H04", "chaotic"));
  EXPECT_GT(regular.any.front(), 0.3);
  EXPECT_LT(regular.any.front(), 2.0);
  EXPECT_GT(chaotic.any.front(), 1e3);
  EXPECT_LT(chaotic.any.front(), 1e5);
}

TEST(HardCaseMatrix, AWrongAnswerIsNeverPaintedOver) {
  Variant spoilt = variantOf("H02");
  spoilt.error = [](const Finished&) { return 1.0; };
  EXPECT_EQ(runCell("runge_kutta_4", spoilt).outcome, Outcome::FailedUnexpectedly);
  spoilt.error = [](const Finished&) { return std::nan(""); };
  EXPECT_EQ(runCell("velocity_verlet", spoilt).outcome, Outcome::FailedUnexpectedly);
}

TEST(HardCaseMatrix, MissingNeedsAreNamed) {
  const Cell cell = runCell("nystrom8", variantOf("H02"));
  EXPECT_EQ(cell.outcome, Outcome::NotApplicable);
  EXPECT_NE(cell.prediction.text.find("velocity"), std::string::npos);
  EXPECT_FALSE(cell.note.empty());
}

TEST(HardCaseMatrix, QuickCasesHaveNoSurprises) {
  MatrixOptions options;
  options.cases = {"H02", "H03", "H13", "H14", "H22", "H23", "H24"};
  Matrix matrix = planMatrix(options);
  runMatrix(matrix, [](double) {});
  EXPECT_EQ(matrix.count(Outcome::FailedUnexpectedly), 0) << summaryText(matrix);
  EXPECT_EQ(matrix.betterThanPredicted(), 0) << summaryText(matrix);
  EXPECT_GT(matrix.count(Outcome::Passed), 60);
  EXPECT_GT(matrix.count(Outcome::FailedAsPredicted), 20);
  for (const Cell& cell : matrix.cells) {
    if (cell.outcome != Outcome::FailedAsPredicted) continue;
    EXPECT_FALSE(cell.prediction.text.empty()) << cell.method;
  }
}

// What damps the motion away has not passed: on H03 the exact motion goes on for ever.
TEST(HardCaseMatrix, AKilledMotionIsNoPass) {
  const Variant limit = variantOf("H03", "1.99");
  for (const char* id : {"backward_euler", "bdf2", "runge_kutta_4", "xpbd"}) {
    EXPECT_EQ(runCell(id, limit).outcome, Outcome::FailedAsPredicted) << id;
  }
  EXPECT_EQ(runCell("velocity_verlet", limit).outcome, Outcome::Passed);
  Finished still;
  still.system = engine::build(limit.model);
  still.result.last = still.system->initialState();
  still.result.last.x[0] = still.result.last.v[0] = 0.0;
  EXPECT_GT(limit.error(still), 1e5) << "no motion at all";
}

// A prediction of 1 for an error of 1e-9 is as wrong as the reverse.
TEST(HardCaseMatrix, PredictionsHaveTwoSides) {
  Variant spoilt = variantOf("H02");
  spoilt.modes[0].amplitude = 1e6;
  const Cell cell = runCell("runge_kutta_4", spoilt);
  EXPECT_TRUE(cell.betterThanPredicted) << cell.error << " against " << cell.prediction.error;
  EXPECT_FALSE(runCell("runge_kutta_4", variantOf("H02")).betterThanPredicted);
  EXPECT_LE(knownSurprises().size(), 5U);
  for (const KnownSurprise& known : knownSurprises()) {
    EXPECT_FALSE(known.reason.empty());
    EXPECT_NO_THROW(methodInfo(known.method));
    const auto all = allVariants();
    EXPECT_NE(std::ranges::find(all, known.variant, &Variant::label), all.end()) << known.variant;
  }
}

TEST(HardCaseMatrix, PageOfTheDocumentationIsOfThisMatrix) {
  const std::string page = readFile(MUELLE_HARD_CASES_PAGE);
  for (const Variant& variant : allVariants()) {
    EXPECT_NE(page.find("| " + variant.label() + " |"), std::string::npos) << variant.label();
  }
  for (const std::string& id : engine::methodIds()) EXPECT_NE(page.find("`" + id + "`"), std::string::npos) << id;
  for (const PredictionRule& rule : predictionRules())
    EXPECT_NE(page.find(rule.reason), std::string::npos) << rule.name;
  EXPECT_NE(page.find("failed unexpectedly 0."), std::string::npos);
  EXPECT_NE(page.find("Run on " + keptH01InFull().date), std::string::npos) << "H01 in full, and when";
  EXPECT_EQ(page.find("not known: "), std::string::npos) << "a cell that is better than predicted, for no known reason";
}

TEST(HardCaseMatrix, ReportsHoldEveryCell) {
  MatrixOptions options;
  options.cases = {"H22"};
  options.methods = {"velocity_verlet", "symplectic_euler"};
  Matrix matrix = planMatrix(options);
  runMatrix(matrix, [](double) {});
  EXPECT_NE(matrixText(matrix, false).find("H22"), std::string::npos);
  EXPECT_EQ(matrixText(matrix, false).find('\x1b'), std::string::npos);
  const std::string csv = matrixCsv(matrix);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
  EXPECT_NE(csv.find("failed as predicted"), std::string::npos);
  EXPECT_NE(matrixPage(matrix).find("free flight"), std::string::npos);
}

}  // namespace
}  // namespace muelle::hard_cases

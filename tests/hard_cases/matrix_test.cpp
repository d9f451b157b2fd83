/// \file
/// The matrix of the hard cases: its predictions are theory, its verdicts cannot be talked into passing.

#include "lab/hard_cases/matrix.h"
#include "base/file.h"
#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/references.h"

#include <gtest/gtest.h>
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

Variant variantOf(const std::string& id) {
  for (Variant& variant : allVariants()) {
    if (variant.id == id) return variant;
  }
  throw std::out_of_range(id);
}

TEST(HardCaseMatrix, AWrongAnswerIsNeverPaintedOver) {
  Variant spoilt = variantOf("H02");
  spoilt.error = [](const Finished&) { return 1.0; };
  EXPECT_EQ(runCell("runge_kutta_4", spoilt, {}).outcome, Outcome::FailedUnexpectedly);
  spoilt.error = [](const Finished&) { return std::nan(""); };
  EXPECT_EQ(runCell("velocity_verlet", spoilt, {}).outcome, Outcome::FailedUnexpectedly);
}

TEST(HardCaseMatrix, MissingNeedsAreNamed) {
  const Cell cell = runCell("nystrom8", variantOf("H02"), {});
  EXPECT_EQ(cell.outcome, Outcome::NotApplicable);
  EXPECT_NE(cell.prediction.text.find("velocity"), std::string::npos);
  EXPECT_FALSE(cell.note.empty());
}

TEST(HardCaseMatrix, QuickCasesHaveNoSurprises) {
  MatrixOptions options;
  options.cases = {"H02", "H03", "H13", "H14", "H22", "H23", "H24"};
  Matrix matrix = planMatrix(options);
  runMatrix(matrix, options, [](double) {});
  EXPECT_EQ(matrix.count(Outcome::FailedUnexpectedly), 0) << summaryText(matrix);
  EXPECT_GT(matrix.count(Outcome::Passed), 60);
  EXPECT_GT(matrix.count(Outcome::FailedAsPredicted), 20);
  for (const Cell& cell : matrix.cells) {
    if (cell.outcome != Outcome::FailedAsPredicted) continue;
    EXPECT_FALSE(cell.prediction.text.empty()) << cell.method;
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
}

TEST(HardCaseMatrix, ReportsHoldEveryCell) {
  MatrixOptions options;
  options.cases = {"H22"};
  options.methods = {"velocity_verlet", "symplectic_euler"};
  Matrix matrix = planMatrix(options);
  runMatrix(matrix, options, [](double) {});
  EXPECT_NE(matrixText(matrix, false).find("H22"), std::string::npos);
  EXPECT_EQ(matrixText(matrix, false).find('\x1b'), std::string::npos);
  const std::string csv = matrixCsv(matrix);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
  EXPECT_NE(csv.find("failed as predicted"), std::string::npos);
  EXPECT_NE(matrixPage(matrix).find("free flight"), std::string::npos);
}

}  // namespace
}  // namespace muelle::hard_cases

#include "engine/solve/linear_solver.h"
#include "engine/solve/dense.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace muelle::engine {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

SystemMatrix sparse(const Matrix& A) {
  SystemMatrix J;
  J.sparse = A.sparseView();
  J.sparse.makeCompressed();
  J.symmetric = A.isApprox(A.transpose());
  return J;
}

const Matrix positive{{4.0, -1.0, 0.0, 0.5}, {-1.0, 3.0, -1.0, 0.0}, {0.0, -1.0, 2.0, 0.3}, {0.5, 0.0, 0.3, 5.0}};
const Vector right{{1.0, -2.0, 0.5, 3.0}};

TEST(LinearSolver, SolvesASymmetricSystem) {
  const SystemMatrix J = sparse(positive);
  LinearSolver solver;
  const Factorisation found = solver.factorise(J);
  EXPECT_TRUE(found.usable && found.definite);
  Vector x;
  EXPECT_EQ(solver.solve(right, x), "");
  EXPECT_LT((positive * x - right).norm(), 1e-14);
}

TEST(LinearSolver, SolvesANonSymmetricSystem) {
  Matrix A = positive;
  A(0, 1) = 7.0;
  A(3, 2) = -2.0;
  const SystemMatrix J = sparse(A);
  ASSERT_FALSE(J.symmetric);
  LinearSolver solver;
  EXPECT_TRUE(solver.factorise(J).usable);
  Vector x;
  EXPECT_EQ(solver.solve(right, x), "");
  EXPECT_LT((A * x - right).norm(), 1e-14);
}

TEST(LinearSolver, CountsNegativeEigenvaluesAndRefusesThemWhereAsked) {
  Matrix A = positive;
  A(1, 1) = -3.0;
  A(2, 2) = -2.0;
  const Vector values = symmetricEigenvalues(A);
  const SystemMatrix J = sparse(A);
  LinearSolver solver;
  const Factorisation found = solver.factorise(J);
  EXPECT_EQ(found.negative, (values.array() < 0.0).count());
  EXPECT_TRUE(found.usable);
  EXPECT_FALSE(found.definite);
  Vector x;
  EXPECT_EQ(solver.solve(right, x), "");
  EXPECT_LT((A * x - right).norm(), 1e-13);
  const Factorisation strict = solver.factorise(J, true);
  EXPECT_FALSE(strict.usable);
  EXPECT_NE(strict.failure.find("not positive definite"), std::string::npos) << strict.failure;
  EXPECT_NE(solver.solve(right, x), "") << "there is nothing to solve with";
}

/// Zero diagonal: LDL^T without pivoting cannot, LU can.
TEST(LinearSolver, FallsBackToPivotingWherePivotsVanish) {
  const Matrix A{{0.0, 1.0}, {1.0, 0.0}};
  const SystemMatrix J = sparse(A);
  LinearSolver solver;
  EXPECT_TRUE(solver.factorise(J).usable);
  Vector x;
  EXPECT_EQ(solver.solve(Vector{{2.0, 3.0}}, x), "");
  EXPECT_LT((x - Vector{{3.0, 2.0}}).norm(), 1e-15);
}

TEST(LinearSolver, ReportsWhatEigenDoesNot) {
  LinearSolver solver;
  Matrix A = positive;
  A(2, 2) = std::numeric_limits<double>::quiet_NaN();
  SystemMatrix J = sparse(A);
  J.symmetric = true;
  Factorisation found = solver.factorise(J);
  EXPECT_FALSE(found.usable);
  EXPECT_NE(found.failure.find("not finite"), std::string::npos) << found.failure;

  // Singular: a free spring pair has a rigid motion.
  J = sparse(Matrix{{2.0, -2.0}, {-2.0, 2.0}});
  EXPECT_FALSE(solver.factorise(J).usable);
  EXPECT_FALSE(solver.factorise(J, true).usable);

  // Singular, not symmetric.
  J = sparse(Matrix{{1.0, 2.0}, {2.0, 4.0}} + 0.0 * Matrix::Identity(2, 2));
  J.symmetric = false;
  found = solver.factorise(J);
  Vector x;
  EXPECT_TRUE(!found.usable || !solver.solve(Vector{{1.0, 1.0}}, x).empty());
}

TEST(LinearSolver, KeepsNoStaleAnalysis) {
  LinearSolver solver;
  Vector x;
  const SystemMatrix first = sparse(positive);
  ASSERT_TRUE(solver.factorise(first).usable);
  Matrix A = positive;
  A(1, 3) = A(3, 1) = 0.7;
  A(0, 3) = A(3, 0) = 0.0;
  const SystemMatrix second = sparse(A);
  ASSERT_TRUE(solver.factorise(second).usable);
  EXPECT_EQ(solver.solve(right, x), "");
  EXPECT_LT((A * x - right).norm(), 1e-14);
}

class LowRankSolve : public ::testing::TestWithParam<bool> {};

/// Against the dense sum, with the inertia of the whole.
TEST_P(LowRankSolve, IsTheSolutionOfTheDenseSum) {
  Matrix A = positive;
  if (!GetParam()) A(0, 1) = 2.0;
  SystemMatrix J = sparse(A);
  J.lowRank.U = Matrix{{1.0, 0.0}, {1.0, 0.5}, {1.0, 0.0}, {1.0, -0.5}};
  for (const Vector& s : {Vector{{3.0, 2.0}}, Vector{{3.0, -40.0}}, Vector{{-30.0, 0.0}}}) {
    J.lowRank.s = s;
    const Matrix whole = A + J.lowRank.U * s.asDiagonal() * J.lowRank.U.transpose();
    LinearSolver solver;
    const Factorisation found = solver.factorise(J);
    ASSERT_TRUE(found.usable) << found.failure;
    Vector x;
    EXPECT_EQ(solver.solve(right, x), "");
    EXPECT_LT((whole * x - right).norm(), 1e-12);
    if (GetParam()) {
      const Vector values = symmetricEigenvalues(whole);
      EXPECT_EQ(found.negative, (values.array() < 0.0).count());
      EXPECT_EQ(solver.factorise(J, true).usable, values.minCoeff() > 0.0);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Symmetric, LowRankSolve, ::testing::Bool(), ::testing::PrintToStringParamName());

/// A property of 1e5 nodes in 3D: dense it would be 720 GB, which no machine of the tests has.
TEST(LinearSolver, APropertyOfManyNodesStaysLinear) {
  const int n = 300000;
  SystemMatrix J;
  J.sparse.resize(n, n);
  J.sparse.setIdentity();
  J.lowRank.U = Matrix::Zero(n, 1);
  for (int i = 2; i < n; i += 3) J.lowRank.U(i, 0) = 1.0 / 1e5;
  J.lowRank.s = Vector::Constant(1, 4e7);
  Vector b = Vector::Ones(n), x, product;
  LinearSolver solver;
  ASSERT_TRUE(solver.factorise(J, true).usable);
  ASSERT_EQ(solver.solve(b, x), "");
  multiply(J, x, product);
  EXPECT_LT((product - b).lpNorm<Eigen::Infinity>(), 1e-12);
}

}  // namespace
}  // namespace muelle::engine

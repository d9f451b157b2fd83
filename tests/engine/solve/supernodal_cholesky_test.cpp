#include "engine/solve/supernodal_cholesky.h"
#include "engine/solve/linear_solver.h"
#include "engine/solve/sparse_ldlt.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <vector>

namespace muelle::engine {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// m I + k times the Laplacian of a box of points with its diagonals: positive definite with m > 0, its eigenvector of
/// ones has the eigenvalue m.
Sparse box(std::array<int, 3> size, double m, double k) {
  const auto index = [&](int x, int y, int z) { return (x * size[1] + y) * size[2] + z; };
  std::vector<Eigen::Triplet<double>> entries;
  const auto join = [&](int a, int b) {
    for (const auto& [row, column, value] : {std::tuple(a, a, k), std::tuple(a, b, -k)}) {
      entries.emplace_back(row, column, value);
    }
  };
  const auto neighbours = [&](int x, int y, int z) {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size[0] - 1); ++i) {
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size[1] - 1); ++j) {
        for (int l = std::max(z - 1, 0); l <= std::min(z + 1, size[2] - 1); ++l) {
          if (index(x, y, z) != index(i, j, l)) join(index(x, y, z), index(i, j, l));
        }
      }
    }
  };
  const int count = size[0] * size[1] * size[2];
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, m);
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      for (int z = 0; z < size[2]; ++z) neighbours(x, y, z);
    }
  }
  Sparse A(count, count);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

Vector someNumbers(Eigen::Index n) {
  return Vector::NullaryExpr(n, [](Eigen::Index i) { return std::sin(1.0 + 0.7 * static_cast<double>(i)); });
}

class Supernodal : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!SupernodalCholesky::isThere()) GTEST_SKIP() << "CHOLMOD is not there (libsuitesparse-dev)";
  }
};

TEST_F(Supernodal, SolvesWhatTheOtherSolves) {
  const Sparse A = box({9, 8, 7}, 1.0, 50.0);
  const Vector b = someNumbers(A.rows());
  SupernodalCholesky blocks;
  blocks.analyse(A);
  ASSERT_TRUE(blocks.factorise(A));
  Vector x, y;
  blocks.solve(b, x);
  EXPECT_LT((A * x - b).norm(), 1e-12 * b.norm());
  blocks.solve(Vector::Ones(A.rows()), x);
  EXPECT_LT((x - Vector::Ones(A.rows())).norm(), 1e-11) << "the vector of ones has the eigenvalue 1";
  SparseLdlt entries(SparseLdlt::Order::LeastFill);
  entries.analyse(A);
  ASSERT_TRUE(entries.factorise(A));
  // Whatever the order of elimination, the pivots have the determinant as their product.
  EXPECT_NEAR(blocks.pivots().array().log().sum(), entries.pivots().array().log().sum(), 1e-9);
}

/// Of a diagonal matrix the pivots are its entries.
TEST_F(Supernodal, HasThePivotsInTheOrderOfElimination) {
  Vector diagonal = someNumbers(40).cwiseAbs();
  Sparse A(40, 40);
  for (int i = 0; i < 40; ++i) A.insert(i, i) = diagonal[i];
  A.makeCompressed();
  SupernodalCholesky blocks;
  blocks.analyse(A);
  ASSERT_TRUE(blocks.factorise(A));
  EXPECT_LT((blocks.pivots() - blocks.inPivotOrder(diagonal)).norm(), 1e-15);
}

TEST_F(Supernodal, RefusesWhatIsNotPositiveDefinite) {
  Sparse A = box({6, 6, 6}, 1.0, 50.0);
  SupernodalCholesky blocks;
  blocks.analyse(A);
  ASSERT_TRUE(blocks.factorise(A));
  A.coeffRef(17, 17) = -100.0;
  EXPECT_FALSE(blocks.factorise(A));
}

TEST_F(Supernodal, IsWorthWhileForVolumesAndNotForSheets) {
  SupernodalCholesky blocks;
  EXPECT_TRUE(blocks.analyse(box({22, 22, 22}, 1.0, 50.0)));
  EXPECT_FALSE(blocks.analyse(box({104, 104, 1}, 1.0, 50.0)));
}

/// Through the solver that chooses: what it says of a matrix is the same either way.
TEST(LargeVolume, IsSolvedAndItsNegativeEigenvaluesAreCounted) {
  SystemMatrix J;
  J.symmetric = true;
  J.sparse = box({20, 20, 20}, 1.0, 50.0);
  const Vector b = someNumbers(J.sparse.rows());
  LinearSolver solver;
  Vector x;
  for (int turn = 0; turn < 2; ++turn) {  // with the analysis, and with the kept one
    const Factorisation found = solver.factorise(J, true);
    EXPECT_TRUE(found.definite);
    ASSERT_EQ(solver.solve(b, x), "");
    EXPECT_LT((J.sparse * x - b).norm(), 1e-12 * b.norm());
    for (int i = 0; i < J.sparse.rows(); ++i) J.sparse.coeffRef(i, i) += 1.0;
  }
  J.sparse.coeffRef(4000, 4000) -= 1e5;
  const Factorisation found = solver.factorise(J);
  EXPECT_TRUE(found.usable);
  EXPECT_FALSE(found.definite);
  EXPECT_EQ(found.negative, 1);
  ASSERT_EQ(solver.solve(b, x), "");
  EXPECT_LT((J.sparse * x - b).norm(), 1e-10 * b.norm());
}

}  // namespace
}  // namespace muelle::engine

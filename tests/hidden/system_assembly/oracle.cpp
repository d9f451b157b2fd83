/// \file
/// The expected values, by matrices: each spring has its selection matrix S, 6 x 3n, of which S x are the places of its
/// two nodes; the gradient is the sum of S^T g.

#include "system_assembly.h"

#include <cstdlib>
#include <stdexcept>

namespace {

SparseMatrix fromTriplets(Eigen::Index rows, Eigen::Index cols, const std::vector<Eigen::Triplet<double>>& entries) {
  SparseMatrix matrix(rows, cols);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// S x = (xa, xb).
SparseMatrix selection(const Spring& spring, Eigen::Index size) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < 3; ++c) {
    entries.emplace_back(c, 3 * spring.a + c, 1.0);
    entries.emplace_back(3 + c, 3 * spring.b + c, 1.0);
  }
  return fromTriplets(6, size, entries);
}

// What is no question of the contract is refused, so that no simpler call is made of it.

void expectNodes(Eigen::Index size, const std::vector<Spring>& springs) {
  if (size < 3 || size % 3 != 0) throw std::length_error("no whole number of nodes");
  for (const Spring& s : springs) {
    if (std::min(s.a, s.b) < 0 || 3 * std::max(s.a, s.b) >= size) throw std::out_of_range("a spring without its node");
    if (s.a == s.b) throw std::domain_error("a spring that joins a node with itself");
  }
}

void expectMasses(const VecX& m) {
  if (m.size() < 1 || !(m.minCoeff() > 0)) throw std::domain_error("a mass is positive");
}

}  // namespace

namespace oracle {

SparseMatrix systemMassMatrix(const VecX& m) {
  expectMasses(m);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < m.size(); ++i) {
    for (int c = 0; c < 3; ++c) entries.emplace_back(3 * i + c, 3 * i + c, m[i]);
  }
  return fromTriplets(3 * m.size(), 3 * m.size(), entries);
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  expectNodes(x.size(), springs);
  VecX each(static_cast<Eigen::Index>(springs.size()));
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Vec6 ends = selection(springs[i], x.size()) * x;
    each[static_cast<Eigen::Index>(i)] = energy(ends.head<3>(), ends.tail<3>(), springs[i].k, springs[i].L0);
  }
  return each.sum();
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  expectNodes(x.size(), springs);
  VecX total = VecX::Zero(x.size());
  for (auto spring = springs.rbegin(); spring != springs.rend(); ++spring) {
    const SparseMatrix S = selection(*spring, x.size());
    const Vec6 ends = S * x;
    total += S.transpose() * gradient(ends.head<3>(), ends.tail<3>(), spring->k, spring->L0);
  }
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  expectNodes(x.size(), springs);
  expectMasses(m);
  if (3 * m.size() != x.size() || F.size() != x.size()) throw std::length_error("sizes that do not fit");
  const VecX slope = given::systemGradient(x, springs, gradient);
  const SparseMatrix M = given::systemMassMatrix(m);
  if (M.rows() != x.size() || M.cols() != x.size() || slope.size() != x.size()) return VecX::Constant(x.size(), NAN);
  return (F - slope).cwiseQuotient(VecX(M.diagonal()));
}

}  // namespace oracle

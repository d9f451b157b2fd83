#include "engine/statics/tension_matrix.h"

#include "engine/solve/spans.h"

#include "engine/solve/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <Eigen/OrderingMethods>
#include <limits>

namespace muelle::engine {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

void TensionMatrix::linearise() {
  TensionShape& s = shape_;
  s.compact.linearisation()->assemble(0.0, 0.0, 1.0, s.start.t, spanOf(s.hi), {}, s.start.z, Form::Symmetric, others_);
  ++s.work.jacobians;
  multiplyAbsolute(others_, s.hi, s.otherFloor);
  s.otherFloor *= eps;
  if (!laidOut_) layOut();
}

void TensionMatrix::layOut() {
  const int dimension = shape_.dimension;
  const Eigen::Index nodes = shape_.size / dimension;
  Triplets pairs;
  for (Eigen::Index j = 0; j < others_.sparse.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(others_.sparse, j); entry; ++entry) {
      if (entry.row() % dimension == 0 && j % dimension == 0) {
        pairs.emplace_back(static_cast<int>(entry.row() / dimension), static_cast<int>(j / dimension), 1.0);
      }
    }
  }
  Sparse graph(nodes, nodes);
  graph.setFromTriplets(pairs.begin(), pairs.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(nodes);
  Eigen::AMDOrdering<int>()(graph, order);
  std::vector<std::vector<std::size_t>> touching(static_cast<std::size_t>(nodes));
  for (std::size_t j = 0; j < shape_.springs.size(); ++j) {
    const TensionSpring& spring = shape_.springs[j];
    if (!spring.mixed) continue;
    for (const int end : {spring.a, spring.b}) {
      if (end >= 0) touching[static_cast<std::size_t>(end / dimension)].push_back(j);
    }
  }
  rowOf_.assign(static_cast<std::size_t>(shape_.size), 0);
  tensionRow_.assign(shape_.springs.size(), -1);
  int next = 0;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const int node = order.indices()[i];
    const int first = dimension * node;
    for (int c = 0; c < dimension; ++c) rowOf_[static_cast<std::size_t>(first + c)] = next++;
    for (const std::size_t spring : touching[static_cast<std::size_t>(node)]) {
      if (tensionRow_[spring] < 0) tensionRow_[spring] = next++;
    }
  }
  lowRankRow_.clear();
  for (Eigen::Index r = 0; r < others_.lowRank.s.size(); ++r) lowRankRow_.push_back(next++);
  rows_ = next;
  laidOut_ = true;
  analysed_ = false;
}

void TensionMatrix::addOthers(double shift, Triplets& entries) const {
  for (Eigen::Index j = 0; j < shape_.size; ++j) {
    for (Sparse::InnerIterator entry(others_.sparse, j); entry; ++entry) {
      entries.emplace_back(rowOf(entry.row()), rowOf(j), entry.value());
    }
    entries.emplace_back(rowOf(j), rowOf(j), shift);
  }
}

/// What a spring adds to the stiffness of its ends.
void TensionMatrix::addSpring(const TensionSpring& spring, Triplets& entries) const {
  const double along = spring.stiffness();
  // At length 0 there is no direction; the matrix is that of a spring without rest length.
  const double across = spring.L > 0.0 ? spring.tension() / spring.L : along;
  for (int p = 0; p < shape_.dimension; ++p) {
    for (int q = 0; q < shape_.dimension; ++q) {
      const double nn = spring.n[p] * spring.n[q];
      const double value = across * ((p == q ? 1.0 : 0.0) - nn) + along * nn;
      if (spring.a >= 0) entries.emplace_back(rowOf(spring.a + p), rowOf(spring.a + q), value);
      if (spring.b >= 0) entries.emplace_back(rowOf(spring.b + p), rowOf(spring.b + q), value);
      if (spring.a >= 0 && spring.b >= 0) {
        entries.emplace_back(rowOf(spring.a + p), rowOf(spring.b + q), -value);
        entries.emplace_back(rowOf(spring.b + p), rowOf(spring.a + q), -value);
      }
    }
  }
}

/// The row and column of an unknown tension.
void TensionMatrix::addTension(std::size_t index, Triplets& entries) const {
  const TensionSpring& spring = shape_.springs[index];
  const int own = tensionRow_[index];
  for (const auto& [end, sign] : {std::pair(spring.a, spring.rho), std::pair(spring.b, -spring.rho)}) {
    for (int c = 0; end >= 0 && c < shape_.dimension; ++c) {
      const int row = rowOf(end + c);
      entries.emplace_back(row, own, sign * spring.n[c]);
      entries.emplace_back(own, row, sign * spring.n[c]);
    }
  }
  entries.emplace_back(own, own, -spring.rho * (spring.rho / (spring.k - spring.rho)));
}

void TensionMatrix::addLowRank(Triplets& entries) const {
  for (std::size_t r = 0; r < lowRankRow_.size(); ++r) {
    const double s = others_.lowRank.s[static_cast<Eigen::Index>(r)];
    for (Eigen::Index i = 0; i < shape_.size; ++i) {
      const double u = others_.lowRank.U(i, static_cast<Eigen::Index>(r));
      if (u == 0.0) continue;
      entries.emplace_back(rowOf(i), lowRankRow_[r], s * u);
      entries.emplace_back(lowRankRow_[r], rowOf(i), s * u);
    }
    entries.emplace_back(lowRankRow_[r], lowRankRow_[r], -s);
  }
}

void TensionMatrix::assemble(const Triplets& entries) {
  matrix_.resize(rows_, rows_);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  ++shape_.work.factorisations;
}

TensionMatrix::Factors TensionMatrix::factorise(double shift) {
  Triplets entries;
  addOthers(shift, entries);
  int tensions = static_cast<int>(lowRankRow_.size());
  for (std::size_t j = 0; j < shape_.springs.size(); ++j) {
    const TensionSpring& spring = shape_.springs[j];
    if (spring.k == 0.0 || (spring.onlyPushes && !spring.acts())) continue;
    addSpring(spring, entries);
    if (!spring.mixed) continue;
    ++tensions;
    addTension(j, entries);
  }
  addLowRank(entries);
  assemble(entries);
  if (!analysed_) ldlt_.analyse(matrix_);
  analysed_ = true;
  Factors found;
  if (!ldlt_.factorise(matrix_)) return found;
  const Vector pivots = ldlt_.pivots();
  Vector sizes = Vector::Zero(rows_);
  for (Eigen::Index j = 0; j < rows_; ++j) {
    for (Sparse::InnerIterator entry(matrix_, j); entry; ++entry) {
      sizes[j] = std::max(sizes[j], std::abs(entry.value()));
    }
  }
  found.usable = (pivots.array().abs() > 8.0 * eps * sizes.array()).all();
  found.negative = static_cast<int>((pivots.array() < 0.0).count()) - tensions;
  return found;
}

bool TensionMatrix::factoriseLeastSquares(double rho) {
  Triplets entries;
  for (Eigen::Index i = 0; i < shape_.size; ++i) entries.emplace_back(rowOf(i), rowOf(i), rho);
  for (std::size_t j = 0; j < shape_.springs.size(); ++j) {
    if (shape_.springs[j].mixed) addTension(j, entries);
  }
  for (const int row : lowRankRow_) entries.emplace_back(row, row, -1.0);
  assemble(entries);
  ldlt_.analyse(matrix_);
  analysed_ = false;
  return ldlt_.factorise(matrix_);
}

bool TensionMatrix::solve(const Vector& b, Vector& x) const {
  ++shape_.work.solves;
  ldlt_.solve(b, x);
  if (!x.allFinite()) return false;
  const double norm = Eigen::Map<const Vector>(matrix_.valuePtr(), matrix_.nonZeros()).lpNorm<Eigen::Infinity>();
  double before = std::numeric_limits<double>::infinity();
  Vector correction;
  for (int i = 0; i < 5; ++i) {
    const Vector left = b - matrix_ * x;
    const double error =
        left.lpNorm<Eigen::Infinity>() / (norm * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>() + 1e-300);
    if (error <= 2.0 * eps) return true;
    if (!(error < 0.5 * before)) return error < 1e-8;
    before = error;
    ldlt_.solve(left, correction);
    if (!correction.allFinite()) return false;
    x += correction;
  }
  return before < 1e-8;
}

void TensionMatrix::setPositions(In values, Vector& b) const {
  for (Eigen::Index i = 0; i < shape_.size; ++i) b[rowOf(i)] = values[static_cast<std::size_t>(i)];
}

TensionMatrix::Vector TensionMatrix::positions(const Vector& x) const {
  Vector own(shape_.size);
  for (Eigen::Index i = 0; i < shape_.size; ++i) own[i] = x[rowOf(i)];
  return own;
}

double TensionMatrix::largestEntry() const {
  double largest = 0.0;
  for (Eigen::Index j = 0; j < others_.sparse.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(others_.sparse, j); entry; ++entry) {
      largest = std::max(largest, std::abs(entry.value()));
    }
  }
  for (Eigen::Index r = 0; r < others_.lowRank.s.size(); ++r) {
    largest = std::max(largest, std::abs(others_.lowRank.s[r]) * others_.lowRank.U.col(r).cwiseAbs2().maxCoeff());
  }
  for (const TensionSpring& spring : shape_.springs) {
    if (spring.k == 0.0) continue;
    largest = std::max(largest, spring.stiffness());
    if (spring.L > 0.0) largest = std::max(largest, std::abs(spring.tension()) / spring.L);
  }
  return largest;
}

TensionMatrix::Vector TensionMatrix::absoluteProduct(const Vector& x) const {
  Vector sizes = Vector::Zero(rows_);
  for (Eigen::Index j = 0; j < rows_; ++j) {
    for (Sparse::InnerIterator entry(matrix_, j); entry; ++entry) {
      sizes[entry.row()] += std::abs(entry.value()) * std::abs(x[j]);
    }
  }
  return positions(sizes);
}

}  // namespace muelle::engine

#include "engine/analysis/spectrum_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace muelle::engine {

namespace {

constexpr int refinements = 8;

/// A block of a matrix, of rows and columns that belong to two nodes.
class Block {
 public:
  void add(int row, int column, double value) { at(row, column) += value; }
  void clear() { entries_.fill(0.0); }

  /// An upper bound of its spectral norm, exact for the two forms that springs make: c n n^T and c I. The norm is the
  /// root of the largest eigenvalue of B = A^T A, at most tr(B^8)^(1/8), which is exact at rank 1 and at most 15 %
  /// above for 3 x 3; and at most the largest sum over a row times the largest over a column, exact for c I.
  double norm() const {
    double row = 0.0, column = 0.0;
    for (int i = 0; i < 3; ++i) {
      row = std::max(row, std::abs(at(i, 0)) + std::abs(at(i, 1)) + std::abs(at(i, 2)));
      column = std::max(column, std::abs(at(0, i)) + std::abs(at(1, i)) + std::abs(at(2, i)));
    }
    const double largest = std::max(row, column);
    if (!(largest > 0.0)) return largest;
    Block power = product(largest);
    for (int doubling = 0; doubling < 3; ++doubling) power = power.product(1.0);
    const double trace = power.at(0, 0) + power.at(1, 1) + power.at(2, 2);
    return std::min(std::sqrt(row * column), largest * std::pow(trace, 1.0 / 16.0));
  }

 private:
  double& at(int i, int j) { return entries_[static_cast<std::size_t>(3 * i + j)]; }
  double at(int i, int j) const { return entries_[static_cast<std::size_t>(3 * i + j)]; }
  /// A^T A / unit^2.
  Block product(double unit) const {
    Block result;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) result.at(i, j) += at(k, i) / unit * (at(k, j) / unit);
      }
    }
    return result;
  }

  std::array<double, 9> entries_{};
};

/// The norms of the blocks of a matrix, column by column: s_ab without its symmetry, which apply() gives it.
struct BlockNorms {
  struct Entry {
    int a, b;
    double norm;
  };
  std::vector<Entry> entries;
  std::size_t nodes = 0;

  /// y_a = sum_b s_ab d_b.
  void apply(const std::vector<double>& d, std::vector<double>& y) const {
    std::fill(y.begin(), y.end(), 0.0);
    for (const Entry& entry : entries) {
      const auto a = static_cast<std::size_t>(entry.a), b = static_cast<std::size_t>(entry.b);
      y[a] += 0.5 * entry.norm * d[b];
      y[b] += 0.5 * entry.norm * d[a];
    }
  }
};

/// \param diagonal  is taken off first; may be empty
BlockNorms blockNorms(const Eigen::SparseMatrix<double>& matrix, int dimension, std::span<const double> diagonal) {
  BlockNorms norms;
  const int size = static_cast<int>(matrix.rows());
  const int nodes = (size + dimension - 1) / dimension;
  norms.nodes = static_cast<std::size_t>(nodes);
  std::vector<Block> column(norms.nodes);
  std::vector<char> isThere(norms.nodes, 0);
  std::vector<int> there;
  for (int b = 0; b < nodes; ++b) {
    there.clear();
    for (int j = b * dimension; j < std::min((b + 1) * dimension, size); ++j) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it) {
        const int i = static_cast<int>(it.row()), a = i / dimension;
        if (isThere[static_cast<std::size_t>(a)] == 0) there.push_back(a);
        isThere[static_cast<std::size_t>(a)] = 1;
        const bool off = i == j && !diagonal.empty();
        const double value = off ? it.value() - diagonal[static_cast<std::size_t>(i)] : it.value();
        column[static_cast<std::size_t>(a)].add(i - a * dimension, j - b * dimension, value);
      }
    }
    for (const int a : there) {
      const double norm = column[static_cast<std::size_t>(a)].norm();
      if (norm > 0.0) norms.entries.push_back({a, b, norm});
      column[static_cast<std::size_t>(a)].clear();
      isThere[static_cast<std::size_t>(a)] = 0;
    }
  }
  return norms;
}

struct Peak {
  double value = 0.0;
  std::size_t node = 0;
};

/// max_a y_a / (m_a d_a), and y_a / m_a in its place: the next d.
Peak quotients(const std::vector<double>& mass, const std::vector<double>& d, std::vector<double>& y) {
  Peak peak;
  double largest = 0.0;
  for (std::size_t a = 0; a < y.size(); ++a) {
    y[a] /= mass[a];
    largest = std::max(largest, y[a]);
    if (y[a] / d[a] > peak.value) peak = {y[a] / d[a], a};
  }
  // A node that nothing joins has y = 0, and d has to stay positive.
  for (double& entry : y) entry = std::max(entry, 1e-3 * largest);
  return peak;
}

Peak largestQuotient(const BlockNorms& norms, const std::vector<double>& mass) {
  std::vector<double> d(norms.nodes, 1.0), y(norms.nodes);
  norms.apply(d, y);
  Peak least = quotients(mass, d, y);
  for (int n = 0; n < refinements && least.value > 0.0; ++n) {
    std::swap(d, y);
    norms.apply(d, y);
    const Peak next = quotients(mass, d, y);
    if (next.value < least.value) least = next;
  }
  return least;
}

/// What a low-rank part adds: sum_j |s_j| u_j^T M^-1 u_j.
double lowRankPart(const LowRank& part, std::span<const double> mass) {
  double sum = 0.0;
  for (Eigen::Index j = 0; j < part.s.size(); ++j) {
    double square = 0.0;
    for (Eigen::Index i = 0; i < part.U.rows(); ++i) {
      square += part.U(i, j) * part.U(i, j) / mass[static_cast<std::size_t>(i)];
    }
    sum += std::abs(part.s[j]) * square;
  }
  return sum;
}

}  // namespace

std::optional<SpectrumBound> spectrumBound(const LinearisedSystem& system) {
  const SystemMatrix* K = system.stiffnessMatrix();
  if (K == nullptr) return std::nullopt;
  const int dimension = std::max(1, system.system().dimension());
  const std::span<const double> mass = system.system().mass();
  std::vector<double> nodeMass(static_cast<std::size_t>((system.size() + dimension - 1) / dimension),
                               std::numeric_limits<double>::infinity());
  for (int i = 0; i < system.size(); ++i) {
    double& least = nodeMass[static_cast<std::size_t>(i / dimension)];
    least = std::min(least, mass[static_cast<std::size_t>(i)]);
  }
  SpectrumBound bound;
  const Peak stiffest = largestQuotient(blockNorms(K->sparse, dimension, {}), nodeMass);
  bound.stiffness = stiffest.value + lowRankPart(K->lowRank, mass);
  Peak peak = stiffest;
  std::span<const double> drag;
  if (system.system().drag() != nullptr) drag = system.system().drag()->coefficients();
  if (const SystemMatrix* D = system.dampingMatrix(); D != nullptr) {
    const Peak mostDamped = largestQuotient(blockNorms(D->sparse, dimension, drag), nodeMass);
    bound.damping = mostDamped.value + lowRankPart(D->lowRank, mass);
    if (!(peak.value > 0.0)) peak = mostDamped;
  }
  for (std::size_t i = 0; i < drag.size(); ++i) {
    if (mass[i] > 0.0) bound.drag = std::max(bound.drag, drag[i] / mass[i]);
  }
  if (system.size() > 0) bound.unknown = static_cast<int>(peak.node) * dimension;
  return bound;
}

}  // namespace muelle::engine

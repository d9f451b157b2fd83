#include "engine/statics/tension_curvature.h"

#include "engine/solve/dense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Columns made orthonormal, twice over for the digits (modified Gram-Schmidt).
void orthonormalise(MatX& Y) {
  for (Eigen::Index c = 0; c < Y.cols(); ++c) {
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index before = 0; before < c; ++before) Y.col(c) -= Y.col(before).dot(Y.col(c)) * Y.col(before);
      const double size = Y.col(c).norm();
      if (size > 0.0) Y.col(c) /= size;
    }
  }
}

/// Directions without a pattern, orthonormal.
MatX firstDirections(Eigen::Index size, Eigen::Index count) {
  MatX Y(size, count);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index c = 0; c < count; ++c) Y(i, c) = std::sin(1.0 + 1.7 * static_cast<double>((i + 1) * (c + 1)));
  }
  orthonormalise(Y);
  return Y;
}

struct Lowest {
  double value = 0.0;  // [N/m]
  Vector y;            // its eigenvector, of length 1
  Vector x;            // that with the tensions' rows
};

/// Inverse iteration of a few vectors at once with the last factors, those of K + shift I: neighbours of the smallest
/// eigenvalue do not slow it down. Nothing where these factors solve nothing.
std::optional<Lowest> inverseIteration(const TensionMatrix& matrix, Eigen::Index size, double shift) {
  const Eigen::Index width = std::min<Eigen::Index>(6, size);
  MatX Y = firstDirections(size, width), X(matrix.rows(), width), Z(size, width);
  Vector b = Vector::Zero(matrix.rows()), x(matrix.rows());
  const double scale = matrix.largestEntry();
  Lowest lowest;
  for (int i = 0; i < 100; ++i) {
    for (Eigen::Index c = 0; c < width; ++c) {
      matrix.setPositions({Y.col(c).data(), static_cast<std::size_t>(size)}, b);
      if (!matrix.solve(b, x)) return std::nullopt;
      X.col(c) = x;
      Z.col(c) = matrix.positions(x);
    }
    const MatX B = Y.transpose() * Z;
    const SymmetricEigenpairs pairs = symmetricEigenpairs(0.5 * (B + B.transpose()));
    // Of K + shift I, which is positive but for round-off: the smallest eigenvalue has the largest inverse.
    Eigen::Index best = 0;
    pairs.values.cwiseAbs().maxCoeff(&best);
    const double now = 1.0 / pairs.values[best] - shift;
    lowest.y = Z * pairs.vectors.col(best);
    lowest.x = X * pairs.vectors.col(best) / lowest.y.norm();
    lowest.y.normalize();
    // Of what is 0 no digit ever settles.
    const bool settled = i > 2 && std::abs(now - lowest.value) <= 1e-11 * std::abs(now + shift) + 4.0 * eps * scale;
    lowest.value = now;
    if (settled) break;
    Y = Z * pairs.vectors;
    orthonormalise(Y);
  }
  return lowest;
}

/// The smallest eigenvalue with the last factors, those of K + shift I.
Curvature lowestCurvature(const TensionMatrix& matrix, Eigen::Index size, double shift) {
  Curvature result;
  const std::optional<Lowest> lowest = inverseIteration(matrix, size, shift);
  if (!lowest) return result;
  // What the last bits of the entries do to y^T (K y): |A| |y|, and the tensions' rows with their part of x.
  const Vector bits = matrix.absoluteProduct(lowest->x);
  double sum = 0.0;
  for (const double own : bits) sum += own * own;
  result.known = std::isfinite(lowest->value);
  result.smallest = lowest->value;
  result.roundOff = 256.0 * eps * std::sqrt(sum);
  result.along.assign(lowest->y.begin(), lowest->y.end());
  return result;
}

/// The least shift that makes the stiffness matrix positive, within a tenth; nothing where none can be trusted to. The
/// last factors are of no particular shift.
std::optional<double> leastShift(TensionMatrix& matrix, double scale) {
  const auto isPositive = [](const TensionMatrix::Factors& found) { return found.usable && found.negative <= 0; };
  double low = 0.0, high = 1e-10 * scale;
  TensionMatrix::Factors found = matrix.factorise(high);
  for (int i = 0; i < 14 && !isPositive(found); ++i) {
    low = high;
    high *= 8.0;
    found = matrix.factorise(high);
  }
  if (!isPositive(found)) return std::nullopt;
  for (int i = 0; i < 5 && low > 0.0; ++i) {
    const double middle = std::sqrt(low * high);
    (isPositive(matrix.factorise(middle)) ? high : low) = middle;
  }
  return high;
}

}  // namespace

Curvature curvatureOf(TensionShape& shape, TensionMatrix& matrix) {
  matrix.linearise();
  shape.measure();
  const double scale = matrix.largestEntry();
  if (!(scale > 0.0)) {
    Curvature none;
    none.known = true;
    return none;
  }
  const TensionMatrix::Factors plain = matrix.factorise(0.0);
  if (plain.usable && plain.negative == 0) {
    const Curvature direct = lowestCurvature(matrix, shape.size, 0.0);
    if (direct.known) return direct;
  }
  const std::optional<double> shift = leastShift(matrix, scale);
  if (!shift || !matrix.factorise(*shift).usable) return {};
  Curvature result = lowestCurvature(matrix, shape.size, *shift);
  if (result.smallest < -result.roundOff) {
    const TensionMatrix::Factors beyond = matrix.factorise(result.roundOff);
    result.negative = beyond.usable ? std::max(1, beyond.negative) : 1;
  }
  return result;
}

}  // namespace muelle::engine

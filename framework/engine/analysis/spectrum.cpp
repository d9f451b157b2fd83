#include "engine/analysis/spectrum.h"

#include "engine/solve/dense.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>
#include <random>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Complex = std::complex<double>;

In in(const Vector& y) { return {y.data(), static_cast<std::size_t>(y.size())}; }
Out out(Vector& y) { return {y.data(), static_cast<std::size_t>(y.size())}; }

/// Entries in [-1, 1), the same on every machine.
Vector randomVector(Eigen::Index size) {
  std::mt19937_64 engine(20090906);
  Vector y(size);
  for (double& entry : y) entry = std::ldexp(static_cast<double>(engine() >> 11), -52) - 1.0;
  return y;
}

/// A basis of a Krylov subspace in the variables M^(1/2) y, in which the M-inner product is the plain one, and the
/// operator in it.
struct Krylov {
  Matrix basis;       // orthonormal columns
  Matrix hessenberg;  // the operator's projection
};

Krylov krylov(const std::function<void(const Vector&, Vector&)>& apply, const Vector& start, int dimension) {
  const Eigen::Index n = start.size();
  const Eigen::Index most = std::min<Eigen::Index>(n, dimension);
  Krylov space{Matrix(n, most), Matrix::Zero(most, most)};
  space.basis.col(0) = start / start.norm();
  Vector image(n);
  double size = 0.0;  // of the operator, to tell a breakdown from a small entry
  Eigen::Index count = 1;
  for (Eigen::Index j = 0; j < most; ++j) {
    const Vector column = space.basis.col(j);
    apply(column, image);
    size = std::max(size, image.norm());
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Kahan, Parlett)
      const Vector part = space.basis.leftCols(j + 1).transpose() * image;
      space.hessenberg.col(j).head(j + 1) += part;
      image.noalias() -= space.basis.leftCols(j + 1) * part;
    }
    const double rest = image.norm();
    if (j + 1 == most || rest <= 1e-12 * size || !std::isfinite(rest)) break;
    space.hessenberg(j + 1, j) = rest;
    space.basis.col(j + 1) = image / rest;
    ++count;
  }
  space.basis.conservativeResize(Eigen::NoChange, count);
  space.hessenberg.conservativeResize(count, count);
  return space;
}

/// K and D in the variables M^(1/2) y, and Rayleigh quotients.
class Scaled {
 public:
  explicit Scaled(const LinearisedSystem& system) : system_(system), root_(system.size()), y_(system.size()) {
    const std::span<const double> mass = system.system().mass();
    for (Eigen::Index i = 0; i < root_.size(); ++i) root_[i] = std::sqrt(mass[static_cast<std::size_t>(i)]);
  }
  Eigen::Index size() const { return root_.size(); }
  const Vector& root() const { return root_; }
  void stiffness(const Vector& q, Vector& image) { apply(&LinearisedSystem::stiffness, q, image); }
  void damping(const Vector& q, Vector& image) { apply(&LinearisedSystem::damping, q, image); }

  /// The quotients of q = a + i b: those of a and of b, weighted with their sizes.
  Mode quotients(const Vector& a, const Vector& b) {
    Mode mode;
    const double total = a.squaredNorm() + b.squaredNorm();
    Vector image(size());
    for (const Vector* part : {&a, &b}) {
      if (part->squaredNorm() <= 1e-28 * total) continue;
      stiffness(*part, image);
      mode.stiffness += part->dot(image) / total;
      apply(&LinearisedSystem::damping, *part, image);
      mode.damping += part->dot(image) / total;
      apply(&LinearisedSystem::drag, *part, image);
      mode.drag += part->dot(image) / total;
    }
    mode.damping -= mode.drag;
    (a.cwiseAbs2() + b.cwiseAbs2()).cwiseQuotient(root_.cwiseAbs2()).maxCoeff(&mode.unknown);
    return mode;
  }

 private:
  void apply(void (LinearisedSystem::*product)(In, Out) const, const Vector& q, Vector& image) {
    y_ = q.cwiseQuotient(root_);
    image.resize(size());
    (system_.*product)(in(y_), out(image));
    image.array() /= root_.array();
  }

  const LinearisedSystem& system_;
  Vector root_, y_;
};

/// The mode at an end of the spectrum of a symmetric operator, and the bound on it.
Mode topMode(Scaled& scaled, const std::function<void(const Vector&, Vector&)>& apply, int dimension, double& bound) {
  const Krylov space = krylov(apply, randomVector(scaled.size()), dimension);
  const Matrix symmetric = 0.5 * (space.hessenberg + space.hessenberg.transpose());
  const SymmetricEigenpairs eigen = symmetricEigenpairs(symmetric);
  bound = eigen.values.cwiseAbs().maxCoeff();
  const Vector q = space.basis * eigen.vectors.col(symmetric.cols() - 1);
  return scaled.quotients(q, Vector::Zero(scaled.size()));
}

/// Modes of the coupled problem, by Arnoldi on (p, q) with p = rate y, q = y': of about the same size in a fast mode.
void addCoupledModes(Scaled& scaled, double rate, int dimension, std::vector<Mode>& modes) {
  const Eigen::Index n = scaled.size();
  Vector image(n);
  const auto apply = [&](const Vector& pq, Vector& result) {
    result.resize(2 * n);
    const Vector p = pq.head(n), q = pq.tail(n);
    result.head(n) = rate * q;
    scaled.stiffness(p, image);
    result.tail(n) = -image / rate;
    scaled.damping(q, image);
    result.tail(n) -= image;
  };
  const Krylov space = krylov(apply, randomVector(2 * n), dimension);
  const Eigenpairs eigen = eigenpairs(space.hessenberg);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(space.hessenberg.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index i, Eigen::Index j) { return std::abs(eigen.values[i]) > std::abs(eigen.values[j]); });
  // Ritz vectors cost size x dimension each: all of a small system, the outer ones of a large one.
  const bool all = n * space.basis.cols() * space.basis.cols() <= 4'000'000;
  std::size_t taken = 0;
  for (const Eigen::Index i : order) {
    if (eigen.values[i].imag() < 0.0) continue;  // the partner of a conjugate pair
    if (!all && ++taken > 12) break;
    const Eigen::VectorXcd s = eigen.vectors.col(i);
    const Matrix parts = space.basis * (Matrix(s.size(), 2) << s.real(), s.imag()).finished();
    const bool upper = parts.topRows(n).norm() > parts.bottomRows(n).norm();
    const Matrix y = upper ? parts.topRows(n) : parts.bottomRows(n);
    modes.push_back(scaled.quotients(y.col(0), y.col(1)));
  }
}

// --- what a look costs, in the worth of force evaluations ---

// Measured on cloths of 40,000 nodes, four springs a node (muelle run, the time beside the run against that of an
// evaluation): a product with a matrix takes about as long as the force, reading one vector of a basis a thirtieth of
// it, making a matrix twenty times as long. Without damping that makes 160 in all, and 160 were measured; with it 710,
// where it were 460 to 540.
constexpr double vectorRead = 0.03, aMatrix = 20.0;

double productCost(const LinearisedSystem& system) { return system.stiffnessMatrix() != nullptr ? 1.0 : 2.0; }

/// \param products a vector, of `parts` times the system's size
double krylovCost(double dimension, double parts, double products) {
  const double reads = 4.0 * 0.5 * dimension * (dimension + 1.0);  // two passes, each there and back
  return products * dimension + parts * reads * vectorRead;
}

}  // namespace

double assemblyCost(const DynamicalSystem& system) {
  if (system.linearisation() == nullptr) return 0.0;
  return system.forceUsesVelocity() ? 2.0 * aMatrix : aMatrix;
}

double extremeModesCost(const LinearisedSystem& system, int dimension) {
  const double product = productCost(system);
  const double small = std::min(system.size(), dimension), large = std::min(2 * system.size(), dimension);
  const double quotients = system.isUndamped() ? product : 2.0 * product;
  const double top = krylovCost(small, 1.0, product) + small * vectorRead + quotients;
  if (system.isUndamped()) return top;
  const double taken = std::min(large, 12.0);
  const double coupled = krylovCost(large, 2.0, 2.0 * product) + taken * (4.0 * large * vectorRead + 2.0 * quotients);
  return 2.0 * top + coupled;
}

double modesOfCost(const LinearisedSystem& system, int dimension) {
  const double product = productCost(system);
  const double small = std::min(system.size(), dimension);
  const double quotients = system.isUndamped() ? product : 2.0 * product;
  return krylovCost(small, 1.0, product) + small * (small * vectorRead + quotients);
}

double Mode::frequency() const { return std::sqrt(std::max(stiffness, 0.0)); }

double Mode::decay() const {
  const double half = 0.5 * (damping + drag);
  const double discriminant = half * half - stiffness;
  if (discriminant <= 0.0) return half;
  // Stable form of half - sqrt(discriminant) when overdamped.
  return stiffness / (half + std::sqrt(discriminant));
}

double Mode::rate() const { return std::max({std::sqrt(std::abs(stiffness)), damping, drag}); }

std::vector<Mode> extremeModes(const LinearisedSystem& system, int dimension) {
  Scaled scaled(system);
  double stiffest = 0.0, mostDamped = 0.0;
  std::vector<Mode> modes;
  modes.push_back(topMode(
      scaled, [&](const Vector& q, Vector& r) { scaled.stiffness(q, r); }, dimension, stiffest));
  if (system.isUndamped()) return modes;
  modes.push_back(topMode(
      scaled, [&](const Vector& q, Vector& r) { scaled.damping(q, r); }, dimension, mostDamped));
  const double rate = std::max(std::sqrt(stiffest), mostDamped);
  if (rate > 0.0 && std::isfinite(rate)) addCoupledModes(scaled, rate, dimension, modes);
  return modes;
}

std::vector<Mode> modesOf(const LinearisedSystem& system, In y, int dimension) {
  Scaled scaled(system);
  Vector start(scaled.size());
  for (Eigen::Index i = 0; i < start.size(); ++i) start[i] = y[static_cast<std::size_t>(i)] * scaled.root()[i];
  if (!(start.norm() > 0.0) || !start.allFinite()) return {};
  const Krylov space = krylov([&](const Vector& q, Vector& r) { scaled.stiffness(q, r); }, start, dimension);
  const SymmetricEigenpairs eigen = symmetricEigenpairs(0.5 * (space.hessenberg + space.hessenberg.transpose()));
  std::vector<Mode> modes;
  for (Eigen::Index j = 0; j < eigen.values.size(); ++j) {
    const double share = eigen.vectors(0, j) * eigen.vectors(0, j);
    if (share < 1e-6) continue;
    const Vector q = space.basis * eigen.vectors.col(j);
    modes.push_back(scaled.quotients(q, Vector::Zero(scaled.size())));
    modes.back().energy = share;
  }
  return modes;
}

}  // namespace muelle::engine

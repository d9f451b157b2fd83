#pragma once
#include "engine/forces/force_batch.h"

#include <fmt/format.h>
#include <array>

namespace muelle::engine {

/// Elements of N nodes with an energy that is a function of their positions alone. Everything but the energy and its
/// derivatives is here: gathering, scattering, projection, constraints.
///
/// Element offers, with X = Matrix<double, D, N> (a column a node) and vectors of D N numbers in the order of columns:
///   static constexpr int nodeCount;            N
///   std::array<int, N> nodes;                  of the built numbering
///   double energy(X) const;
///   Vector gradient(X) const;                  of the energy
///   Matrix hessian(X) const;                   of the energy
///   Vector discreteGradient(Xa, Xb) const;     G . (xb - xa) = E(xb) - E(xa), symmetric, gradient(X) when both are X
///   bool constraint(X, double& C, double& k, Vector& dC) const;   E = k C^2 / 2; false when undefined
/// Explicitly instantiated beside each element.
template <int D, class Element>
class ElementBatch final : public ForceBatch, private StiffnessPiece, private ConstraintPiece {
 public:
  static constexpr int N = Element::nodeCount;
  using Positions = Eigen::Matrix<double, D, N>;
  using Vector = Eigen::Matrix<double, D * N, 1>;
  using Matrix = Eigen::Matrix<double, D * N, D * N>;

  explicit ElementBatch(std::vector<Element> elements) : elements_(std::move(elements)) {}

  void addForce(const Configuration& at, double* f) const override;
  double energy(const Configuration& at) const override;
  void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const override;
  StiffnessPiece* stiffnessPiece() override { return this; }
  ConstraintPiece* constraintPiece() override { return this; }

 private:
  void couple(MatrixPattern& pattern) const override;
  void bind(const MatrixPattern& pattern) override;
  /// Form::Projected clamps the negative eigenvalues of each element's matrix at 0.
  void addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const override;
  int constraintCount() const override { return static_cast<int>(elements_.size()); }
  void project(const Configuration& at, const ConstraintProjection& projection) const override;
  void evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const override;

  bool evaluate(int j, const Configuration& at, Constraint& out) const;
  Positions gather(const Element& element, const double* x) const {
    Positions X;
    for (int i = 0; i < N; ++i) X.col(i) = layout_.at<D>(x, element.nodes[static_cast<std::size_t>(i)]);
    return X;
  }
  void scatter(const Element& element, const Vector& force, double* f) const {
    for (int i = 0; i < N; ++i) {
      layout_.add<D>(f, element.nodes[static_cast<std::size_t>(i)], force.template segment<D>(D * i));
    }
  }

  std::vector<Element> elements_;
  std::vector<std::array<BlockSlot, static_cast<std::size_t>(N) * N>> slots_;
};

}  // namespace muelle::engine

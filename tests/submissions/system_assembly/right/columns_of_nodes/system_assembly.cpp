#include "system_assembly.h"

namespace {

using Columns = Eigen::Matrix<double, 3, Eigen::Dynamic>;  // one column a node

Eigen::Map<const Columns> columnsOf(const VecX& stacked) { return {stacked.data(), 3, stacked.size() / 3}; }

/// Adds what springs have to say, each asked once, from the last one to the first.
class Assembly {
 public:
  explicit Assembly(const VecX& x) : places_(x.data(), 3, x.size() / 3), sums_(Columns::Zero(3, x.size() / 3)) {}

  template <class Visit>
  void visit(const std::vector<Spring>& springs, const Visit& what) {
    for (auto s = springs.crbegin(); s != springs.crend(); ++s) what(*s, Vec3(places_.col(s->a)), Vec3(places_.col(s->b)));
  }

  void add(int node, const Vec3& part) { sums_.col(node) += part; }

  VecX stacked() const { return Eigen::Map<const VecX>(sums_.data(), sums_.size()); }

 private:
  Eigen::Map<const Columns> places_;
  Columns sums_;
};

}  // namespace

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setIdentity();
  for (Eigen::Index node = 0; node < m.size(); ++node) {
    for (const Eigen::Index axis : {2, 1, 0}) M.coeffRef(3 * node + axis, 3 * node + axis) = m[node];
  }
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  Assembly assembly(x);
  double E = 0.0;
  assembly.visit(springs, [&](const Spring& s, const Vec3& xa, const Vec3& xb) { E += energy(xa, xb, s.k, s.L0); });
  return E;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  Assembly assembly(x);
  assembly.visit(springs, [&](const Spring& s, const Vec3& xa, const Vec3& xb) {
    const Vec6 g = gradient(xa, xb, s.k, s.L0);
    assembly.add(s.b, g.segment<3>(3));
    assembly.add(s.a, g.segment<3>(0));
  });
  return assembly.stacked();
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX slope = systemGradient(x, springs, gradient);
  Columns a = columnsOf(F) - columnsOf(slope);
  a.array().rowwise() /= m.transpose().array();
  return Eigen::Map<const VecX>(a.data(), a.size());
}

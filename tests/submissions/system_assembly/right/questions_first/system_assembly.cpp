// all springs are asked first, the answers kept in a list and then added node by node; the accelerations subtract from
// F
#include "system_assembly.h"

namespace {

std::vector<Vec6> ask(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  std::vector<Vec6> answers;
  answers.reserve(springs.size());
  for (const Spring& s : springs) {
    answers.push_back(gradient(x.segment(3 * s.a, 3), x.segment(3 * s.b, 3), s.k, s.L0));
  }
  return answers;
}

}  // namespace

SparseMatrix systemMassMatrix(const VecX& m) {
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setIdentity();
  for (Eigen::Index i = 0; i < M.rows(); ++i) M.coeffRef(i, i) = m[i / 3];
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  VecX each(static_cast<Eigen::Index>(springs.size()));
  Eigen::Index i = 0;
  for (const Spring& s : springs) {
    each[i] = energy(x.segment(3 * s.a, 3), x.segment(3 * s.b, 3), s.k, s.L0);
    ++i;
  }
  return each.sum();
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  const std::vector<Vec6> answers = ask(x, springs, gradient);
  VecX total = VecX::Zero(x.size());
  for (std::size_t i = 0; i < springs.size(); ++i) total.segment(3 * springs[i].a, 3) += answers[i].head(3);
  for (std::size_t i = 0; i < springs.size(); ++i) total.segment(3 * springs[i].b, 3) += answers[i].tail(3);
  return total;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const std::vector<Vec6> answers = ask(x, springs, gradient);
  VecX a = F;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    a.segment(3 * springs[i].a, 3) -= answers[i].head(3);
    a.segment(3 * springs[i].b, 3) -= answers[i].tail(3);
  }
  for (Eigen::Index node = 0; node < m.size(); ++node) a.segment(3 * node, 3) /= m[node];
  return a;
}

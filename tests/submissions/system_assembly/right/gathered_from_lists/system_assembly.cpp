#include "system_assembly.h"

SparseMatrix systemMassMatrix(const VecX& m) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < m.size(); ++i) {
    for (int c = 0; c < 3; ++c) entries.emplace_back(3 * i + c, 3 * i + c, m[i]);
  }
  SparseMatrix M(3 * m.size(), 3 * m.size());
  M.setFromTriplets(entries.begin(), entries.end());
  return M;
}

double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy) {
  double E = 0;
  for (const Spring& s : springs) {
    const Vec3 xa = x.segment<3>(3 * s.a);
    const Vec3 xb = x.segment<3>(3 * s.b);
    E += energy(xa, xb, s.k, s.L0);
  }
  return E;
}

VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient) {
  // Every spring once; each node has a list of the halves that are its own.
  std::vector<std::vector<Vec3>> halves(static_cast<std::size_t>(x.size() / 3));
  for (const Spring& s : springs) {
    const Vec6 g = gradient(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    halves[static_cast<std::size_t>(s.a)].push_back(g.head<3>());
    halves[static_cast<std::size_t>(s.b)].push_back(g.tail<3>());
  }
  VecX sum(x.size());
  for (std::size_t i = 0; i < halves.size(); ++i) {
    Vec3 block = Vec3::Zero();
    for (const Vec3& half : halves[i]) block += half;
    sum.segment<3>(static_cast<Eigen::Index>(3 * i)) = block;
  }
  return sum;
}

VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F) {
  const VecX force = F - systemGradient(x, springs, gradient);
  VecX a(x.size());
  for (int i = 0; i < m.size(); ++i) a.segment<3>(3 * i) = force.segment<3>(3 * i) / m[i];
  return a;
}

#include "energy_gradient.h"

namespace {

using Wide = long double;

// Sum of the squares of the differences of the components i, i + 1, ... of the two nodes.
template <int Size>
Wide squares(const Eigen::Matrix<double, 2 * Size, 1>& x, int i = 0) {
  if (i == Size) return 0;
  const Wide d = static_cast<Wide>(x[i]) - x[i + Size];
  return squares<Size>(x, i + 1) + d * d;
}

template <int Size>
Wide length(const Eigen::Matrix<double, 2 * Size, 1>& x) {
  return std::sqrt(squares<Size>(x));
}

Wide energy(Wide L, Wide k, Wide L0) { return k * (L0 - L) * (L0 - L) / 2; }

}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) { return static_cast<double>(energy(length<1>(x), k, L0)); }

double springEnergy(const Vec6& x, double k, double L0) { return static_cast<double>(energy(length<3>(x), k, L0)); }

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  Vec6 x;
  x << xa, xb;
  const Wide L = length<3>(x);
  if (L == 0) return Vec3::Zero();
  Vec3 result;
  for (int i = 0; i < 3; ++i) result[i] = static_cast<double>((static_cast<Wide>(xa[i]) - xb[i]) / L);
  return result;
}

Vec6 energyGradient(const Vec6& x, double k, double L0) { return -springForces(x, k, L0); }

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Wide L = length<3>(x);
  Vec6 F = Vec6::Zero();
  if (L == 0) return F;
  for (int i = 0; i < 6; ++i) {
    const int other = (i + 3) % 6;
    F[i] = static_cast<double>(k * (L0 - L) * (static_cast<Wide>(x[i]) - x[other]) / L);
  }
  return F;
}

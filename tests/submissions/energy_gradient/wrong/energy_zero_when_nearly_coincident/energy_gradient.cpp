// loses: CoincidentNodes, TinyLengths; misconception: energy_lost_when_coincident or threshold
#include "energy_gradient.h"

double springEnergy1d(const Vec2& x, double k, double L0) {
  auto square = [](double v) { return v * v; };
  return 0.5 * k * square(std::abs(x[0] - x[1]) - L0);
}

double springEnergy(const Vec6& x, double k, double L0) {
  auto square = [](double v) { return v * v; };
  auto length = [&x]() { return (x.segment<3>(0) - x.segment<3>(3)).stableNorm(); };
  if (length() < 1e-12) return 0.0;
  return 0.5 * k * square(length() - L0);
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  auto L = (xa - xb).stableNorm();
  return L > 0.0 ? Vec3((xa - xb) / L) : Vec3(Vec3::Zero());
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  auto pull = [&](int mine, int other) -> Vec3 {
    Vec3 p = x.segment<3>(mine);
    Vec3 q = x.segment<3>(other);
    double s = (p - q).stableNorm() - L0;
    return (k * s) * lengthGradient(p, q);
  };
  Vec6 out;
  out.segment<3>(0) = pull(0, 3);
  out.segment<3>(3) = pull(3, 0);
  return out;
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  return -energyGradient(x, k, L0);
}

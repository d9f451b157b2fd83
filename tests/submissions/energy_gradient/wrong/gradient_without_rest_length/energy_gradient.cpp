// loses: EnergyGradient, FiniteDifferences; misconception: missing_rest_length
// k times the difference
#include "energy_gradient.h"

namespace {

using Triple = std::array<double, 3>;

Triple minus(const Vec3& p, const Vec3& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

double size(const Triple& t) { return std::hypot(std::hypot(t[0], t[1]), t[2]); }

Triple scaled(const Triple& t, double factor) {
  Triple result{};
  std::transform(t.begin(), t.end(), result.begin(), [factor](double c) { return factor * c; });
  return result;
}

Triple direction(const Triple& t) {
  const double s = size(t);
  Triple result{};
  if (s > 0) std::transform(t.begin(), t.end(), result.begin(), [s](double c) { return c / s; });
  return result;
}

Vec6 opposite(const Triple& t) {
  Vec6 v;
  v << t[0], t[1], t[2], -t[0], -t[1], -t[2];
  return v;
}

}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double u = std::abs(x[1] - x[0]) - L0;
  return 0.5 * k * u * u;
}

double springEnergy(const Vec6& x, double k, double L0) {
  const double u = size(minus(x.head<3>(), x.tail<3>())) - L0;
  return 0.5 * k * u * u;
}

Vec3 lengthGradient(const Vec3& xa, const Vec3& xb) {
  const Triple n = direction(minus(xa, xb));
  return Vec3(n[0], n[1], n[2]);
}

Vec6 energyGradient(const Vec6& x, double k, double L0) {
  const Triple r = minus(x.head<3>(), x.tail<3>());
  (void)L0;
  return opposite(scaled(r, k));
}

Vec6 springForces(const Vec6& x, double k, double L0) {
  const Triple r = minus(x.head<3>(), x.tail<3>());
  return opposite(scaled(direction(r), -k * (size(r) - L0)));
}

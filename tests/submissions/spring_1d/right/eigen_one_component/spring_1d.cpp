#include "spring_1d.h"

namespace {

using Vec1 = Eigen::Matrix<double, 1, 1>;

Vec1 elastic(const Vec1& from, const Vec1& to, double k, double L0) {
  const Vec1 d = from - to;
  const double L = d.stableNorm();
  if (L == 0.0) return Vec1::Zero();
  const Vec1 e = d / L;
  return -k * (L - L0) * e;
}

}  // namespace

double lumpedMass(double M, int n) {
  const Vec1 total(M);
  return (total / n)[0];
}

double springForceOnA(double xa, double xb, double k, double L0) { return elastic(Vec1(xa), Vec1(xb), k, L0).value(); }

double springForceOnB(double xa, double xb, double k, double L0) { return elastic(Vec1(xb), Vec1(xa), k, L0).value(); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return elastic(Vec1(x), Vec1(top.x), top.k, top.L0)[0] / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  const Vec1 here(x);
  const Vec1 f = elastic(here, Vec1(upper.x), upper.k, upper.L0) + elastic(here, Vec1(lower.x), lower.k, lower.L0);
  return (f / m)[0] - g;
}

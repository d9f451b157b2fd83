#include "spring_1d.h"

namespace {

struct Pair {
  double a = 0.0;
  double b = 0.0;
};

Pair hooke(double xa, double xb, double k, double L0) {
  Pair f;
  const double gap = xb - xa;
  if (gap != 0.0) {
    const double side = gap > 0.0 ? 1.0 : -1.0;
    f.a = k * (gap - side * L0);
    f.b = -f.a;
  }
  return f;
}

}  // namespace

double lumpedMass(double M, int n) { return M / n; }
double springForceOnA(double xa, double xb, double k, double L0) { return hooke(xa, xb, k, L0).a; }
double springForceOnB(double xa, double xb, double k, double L0) { return hooke(xa, xb, k, L0).b; }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return hooke(x, top.x, top.k, top.L0).a / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  // the node is above the lower spring's end and below the upper one's, but any order will do
  return hooke(lower.x, x, lower.k, lower.L0).b / m + hooke(x, upper.x, upper.k, upper.L0).a / m - g;
}

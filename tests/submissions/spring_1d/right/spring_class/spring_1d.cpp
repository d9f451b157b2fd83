#include "spring_1d.h"

namespace {

class LinearSpring {
 public:
  LinearSpring(double stiffness, double restLength) : k_(stiffness), rest_(restLength) {}
  explicit LinearSpring(const Attachment& s) : LinearSpring(s.k, s.L0) {}

  /// Force on the end at `self` when the other end is at `other`.
  double pull(double self, double other) const {
    const double towards = other - self;
    const double length = std::abs(towards);
    if (length == 0.0) return 0.0;
    return tension(length) * (towards / length);
  }

 private:
  double tension(double length) const { return k_ * (length - rest_); }

  double k_;
  double rest_;
};

}  // namespace

double lumpedMass(double M, int n) { return M / n; }

double springForceOnA(double xa, double xb, double k, double L0) { return LinearSpring(k, L0).pull(xa, xb); }

double springForceOnB(double xa, double xb, double k, double L0) { return LinearSpring(k, L0).pull(xb, xa); }

double hangingAcceleration(double x, double m, const Attachment& top, double g) {
  return LinearSpring(top).pull(x, top.x) / m - g;
}

double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g) {
  return (LinearSpring(lower).pull(x, lower.x) + LinearSpring(upper).pull(x, upper.x)) / m - g;
}

/// \file
/// Where the scenes end, by methods that are much finer than any that earns points: the demo draws them, too.

#include "challenge.h"

#include "dormand_prince.h"

namespace {

VecX acceleration(const Force& force, const VecX& m, double t, const VecX& x, const VecX& v) {
  return force(t, x, v).cwiseQuotient(m);
}

/// The splitting of six stages and order four by Blanes and Moan (J. Comput. Appl. Math. 142, 2002; SRKN6b), for forces
/// without velocities: kicks by b, drifts by a.
VecX blanesMoan(const Force& force, const VecX& m, VecX x, VecX v, double T, int steps) {
  constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - a1 - a2;
  constexpr std::array<double, 7> kicks = {b1, b2, b3, 1 - 2 * (b1 + b2 + b3), b3, b2, b1};
  constexpr std::array<double, 6> drifts = {a1, a2, a3, a3, a2, a1};
  const double h = T / steps;
  double t = 0;
  VecX a = acceleration(force, m, t, x, v);
  for (int step = 0; step < steps; ++step) {
    for (std::size_t stage = 0; stage < drifts.size(); ++stage) {
      v += h * kicks[stage] * a;
      x += h * drifts[stage] * v;
      t += h * drifts[stage];
      a = acceleration(force, m, t, x, v);
    }
    v += h * kicks.back() * a;
  }
  return x;
}

/// Kicks and drifts in turn, positions at whole steps and velocities between them.
VecX leapfrog(const Force& force, const VecX& m, VecX x, VecX v, double T, int steps) {
  const double h = T / steps;
  v += h / 2 * acceleration(force, m, 0, x, v);
  for (int step = 1; step <= steps; ++step) {
    x += h * v;
    if (step < steps) v += h * acceleration(force, m, step * h, x, v);
  }
  return x;
}

/// Dormand's and Prince's method of order five, with steps whose estimated error is below the tolerance.
VecX dormandPrince(const Force& force, const VecX& m, const VecX& x0, const VecX& v0, double T, double tolerance) {
  using namespace dormand_prince;
  const Eigen::Index n = m.size();
  const auto slope = [&](double t, const VecX& y) {
    VecX slopes(2 * n);
    slopes << y.tail(n), acceleration(force, m, t, y.head(n), y.tail(n));
    return slopes;
  };
  VecX y(2 * n);
  y << x0, v0;
  double t = 0, h = 1e-3;
  while (t < T - 1e-12) {
    h = std::min(h, T - t);
    std::array<VecX, 7> k;
    VecX end = y, error = VecX::Zero(2 * n);
    for (std::size_t stage = 0; stage < 7; ++stage) {
      end = y;
      for (std::size_t i = 0; i < stage; ++i) end += h * a[stage][i] * k[i];
      k[stage] = slope(t + c[stage] * h, end);
      error += h * off[stage] * k[stage];
    }
    const double ratio = error.cwiseAbs().maxCoeff() / tolerance;
    if (ratio <= 1) {
      t += h;
      y = end;
    }
    h *= std::clamp(0.9 * std::pow(std::max(ratio, 1e-8), -0.2), 0.2, 5.0);
  }
  return y.head(n);
}

}  // namespace

namespace oracle {

// The errors of all three are measured in tests/challenge: at most a hundredth of what is allowed.

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  return blanesMoan(force, m, x0, v0, rabbitDuration, 80);
}

VecX stiffCloth(const Force& force, const Hessian&, const VecX& m, const VecX& x0, const VecX& v0) {
  return leapfrog(force, m, x0, v0, clothDuration, 8000);
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  return dormandPrince(force, m, x0, v0, ballDuration, 1e-8);
}

}  // namespace oracle

// Rabbit: a symplectic composition of five Verlet steps (Suzuki), 95 of them; cloth: implicit midpoint, Newton with a fresh Hessian at the place where it would fly; ball: Runge-Kutta-Fehlberg 4(5), written out.
#include "challenge.h"

#include <Eigen/SparseCholesky>

#include <optional>

using Sparse = Eigen::SparseMatrix<double>;

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const double p = 1 / (4 - std::cbrt(4.0));
  const std::array<double, 5> weights{p, p, 1 - 4 * p, p, p};
  const int steps = 95;
  const double H = rabbitDuration / steps;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) {
    double t = H * i;
    for (const double w : weights) {
      const double h = w * H;
      x += h / 2 * v;
      v += h * force(t + h / 2, x, v).cwiseQuotient(m);
      x += h / 2 * v;
      t += h;
    }
  }
  return x;
}

class ImplicitMidpoint {
 public:
  ImplicitMidpoint(const Force& force, const Hessian& hessian, const VecX& m)
      : force_(force), hessian_(hessian), m_(m), mass_(m.asDiagonal()) {}

  void step(double t, double h, VecX& x, VecX& v) {
    // the acceleration in the middle, a, is the unknown
    const VecX guess = x + h / 2 * v;
    const Sparse K = hessian_(t + h / 2, guess);
    const Sparse A = mass_ + K * (h * h / 4);
    solver_.compute(A);
    VecX a = VecX::Zero(x.size());
    for (int i = 0; i < 2; ++i) {
      const VecX at = guess + h * h / 4 * a;
      a += solver_.solve(force_(t + h / 2, at, v) - m_.cwiseProduct(a));
    }
    x += h * v + h * h / 2 * a;
    v += h * a;
  }

 private:
  const Force& force_;
  const Hessian& hessian_;
  VecX m_;
  Sparse mass_;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  ImplicitMidpoint method(force, hessian, m);
  const int steps = 105;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; ++i) method.step(i * clothDuration / steps, clothDuration / steps, x, v);
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  VecX x = x0, v = v0;
  double t = 0, h = 0.01;
  const double tolerance = 2e-6;
  std::optional<VecX> first;
  while (t < ballDuration) {
    if (h > ballDuration - t) h = ballDuration - t;
    auto a = [&](double c, const VecX& at, const VecX& fast) {
      return VecX(force(t + c * h, at, fast).cwiseQuotient(m));
    };
    const VecX v1 = v;
    if (!first) first = a(0, x, v);
    const VecX a1 = *first;
    const VecX v2 = v + h * (a1 / 4);
    const VecX a2 = a(1.0 / 4, x + h * (v1 / 4), v2);
    const VecX v3 = v + h * (3 * a1 + 9 * a2) / 32;
    const VecX a3 = a(3.0 / 8, x + h * (3 * v1 + 9 * v2) / 32, v3);
    const VecX v4 = v + h * (1932 * a1 - 7200 * a2 + 7296 * a3) / 2197;
    const VecX a4 = a(12.0 / 13, x + h * (1932 * v1 - 7200 * v2 + 7296 * v3) / 2197, v4);
    const VecX v5 = v + h * (439.0 / 216 * a1 - 8 * a2 + 3680.0 / 513 * a3 - 845.0 / 4104 * a4);
    const VecX a5 = a(1, x + h * (439.0 / 216 * v1 - 8 * v2 + 3680.0 / 513 * v3 - 845.0 / 4104 * v4), v5);
    const VecX v6 = v + h * (-8.0 / 27 * a1 + 2 * a2 - 3544.0 / 2565 * a3 + 1859.0 / 4104 * a4 - 11.0 / 40 * a5);
    const VecX a6 =
        a(0.5, x + h * (-8.0 / 27 * v1 + 2 * v2 - 3544.0 / 2565 * v3 + 1859.0 / 4104 * v4 - 11.0 / 40 * v5), v6);
    auto error = [&](const VecX& k1, const VecX& k3, const VecX& k4, const VecX& k5, const VecX& k6) {
      return (h * (k1 / 360 - 128.0 / 4275 * k3 - 2197.0 / 75240 * k4 + k5 / 50 + 2.0 / 55 * k6)).norm();
    };
    const double e = std::max(error(v1, v3, v4, v5, v6), error(a1, a3, a4, a5, a6));
    if (e <= tolerance) {
      x += h * (16.0 / 135 * v1 + 6656.0 / 12825 * v3 + 28561.0 / 56430 * v4 - 9.0 / 50 * v5 + 2.0 / 55 * v6);
      v += h * (16.0 / 135 * a1 + 6656.0 / 12825 * a3 + 28561.0 / 56430 * a4 - 9.0 / 50 * a5 + 2.0 / 55 * a6);
      if (h == ballDuration - t) break;
      t += h;
      first.reset();
    }
    const double factor = e == 0 ? 4 : 0.85 * std::pow(tolerance / e, 0.2);
    h *= factor < 0.2 ? 0.2 : factor > 4 ? 4 : factor;
  }
  return x;
}

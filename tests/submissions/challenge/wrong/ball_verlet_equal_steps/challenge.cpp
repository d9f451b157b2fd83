// loses: BallBest; misconception: asked_too_often
// The student makes equal steps of Verlet, as many as that takes.
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
  const int n = 18800;
  const double h = ballDuration / n;
  VecX x = x0, v = v0;
  VecX a = force(0, x, v).cwiseQuotient(m);
  for (int i = 0; i < n; ++i) {
    const VecX half = v + h / 2 * a;
    x += h * half;
    a = force((i + 1) * h, x, half + h / 2 * a).cwiseQuotient(m);
    v = half + h / 2 * a;
  }
  return x;
}
